// SPDX-License-Identifier: BSD-3-Clause
// In every plug-in: the build that it belongs to, as BuildId of the program (host/version_text.h).
#include "limn/version.h"

#include <boost/config.hpp>

#include "limn/commit.h"

extern "C" BOOST_SYMBOL_EXPORT const char* limn_plugin_build();
const char* limn_plugin_build() { return LIMN_VERSION " " LIMN_COMMIT; }
