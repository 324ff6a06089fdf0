# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts beside it: apt with lists of its own, so that packages of other releases, or sources, can be
# downloaded and nothing of the system changes.

# debian_mirror <label>: the one that the machine's apt uses.
debian_mirror() {
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' "Label: $1" | sed -n 1p
}

# lasting_root <folder> <release> <options of mmdebstrap ...>: a Debian root in the folder, unless it is there.
lasting_root() {
  local mirror
  [[ ! -d $1 ]] || return 0
  mirror=$(debian_mirror Debian)
  mkdir -p "$(dirname "$1")"
  rm -rf "$1.part"
  mmdebstrap --quiet "${@:3}" "$2" "$1.part" "${mirror:-http://deb.debian.org/debian}"
  mv "$1.part" "$1"
}

# own_apt <folder> <deb or deb-src> <releases>: from here on `apt_get ...` is apt-get with these lists.
own_apt() {
  own_apt_folder=$1
  local mirror security
  mirror=$(debian_mirror Debian)
  security=$(debian_mirror Debian-Security)
  mkdir -p "$own_apt_folder"/{lists/partial,cache/archives/partial,parts}
  cat >"$own_apt_folder/parts/debian.sources" <<END
Types: $2
URIs: ${mirror:-http://deb.debian.org/debian}
Suites: $3
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg

Types: $2
URIs: ${security:-http://deb.debian.org/debian-security}
Suites: $(printf '%s-security ' $3)
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
  apt_get update
}

apt_get() {
  apt-get -q -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$own_apt_folder/parts" \
    -o Dir::State::Lists="$own_apt_folder/lists" -o Dir::Cache="$own_apt_folder/cache" -o APT::Sandbox::User=root "$@"
}
