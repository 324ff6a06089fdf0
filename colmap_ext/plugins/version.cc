// In every plug-in: the version that it was built with.
#include "limn/version.h"

#include <boost/config.hpp>

extern "C" BOOST_SYMBOL_EXPORT const char* limn_plugin_version();
const char* limn_plugin_version() { return LIMN_VERSION; }
