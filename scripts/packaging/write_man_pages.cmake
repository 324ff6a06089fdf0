# SPDX-License-Identifier: BSD-3-Clause
# cmake -DLIMN=<program> -DFOLDER=<folder> -P write_man_pages.cmake: limn.1 and a page per command, told by the program.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${LIMN} help --help_format words OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" commands "${commands}")
execute_process(COMMAND ${LIMN} help --help_format man OUTPUT_FILE ${FOLDER}/limn.1 COMMAND_ERROR_IS_FATAL ANY)
foreach(command ${commands})
  execute_process(
    COMMAND ${LIMN} ${command} --help_format man OUTPUT_FILE ${FOLDER}/limn-${command}.1 COMMAND_ERROR_IS_FATAL ANY)
endforeach()
