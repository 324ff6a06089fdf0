#include "limn/refinement/refinement_options.h"

#include "limn/util/errors.h"

namespace limn {

void RefinementOptions::Check() const {
  CheckFields(*this);
  CheckOption(!refine_poses || num_rounds > 0, "refine_poses", 1, "0 when num_rounds is 0");
}

}  // namespace limn
