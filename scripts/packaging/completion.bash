# SPDX-License-Identifier: BSD-3-Clause
# Completion of limn in Bash: commands, options, the words that an option takes, files and folders for paths. The
# program itself tells them, so that they are those of the version that is run.

# _limn_complete_value <word> <what may follow the option...>
_limn_complete_value() {
  local word=$1
  shift
  if [[ ${1:-} == '<path>' ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  elif [[ ${1:-} != '<'* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$*" -- "$word")
  fi
}

_limn() {
  COMPREPLY=()
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  # Bash takes --option=value for three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "help --version $("$1" help --help_format words 2>/dev/null)" -- "$word")
    return
  fi
  local line options=()
  while read -r line; do
    # shellcheck disable=SC2086 # words
    set -- "$1" $line
    if [[ $2 == "$before" && $# -gt 2 ]]; then
      _limn_complete_value "$word" "${@:3}"
      return
    fi
    # Only options of several texts may be given again.
    [[ ${3:-} != '<texts>' && " ${COMP_WORDS[*]:2:COMP_CWORD-2} " == *" $2 "* ]] || options+=("$2")
  done < <("$1" "${COMP_WORDS[1]}" --help_format words 2>/dev/null)
  mapfile -t COMPREPLY < <(compgen -W "${options[*]}" -- "$word")
}

complete -F _limn limn
