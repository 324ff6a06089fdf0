#include "limn/refinement/refinement_options.h"

namespace limn {

void RefinementOptions::Check() const { CheckFields(*this); }

}  // namespace limn
