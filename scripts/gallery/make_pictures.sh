#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The pictures of colmap_ext/docs/gallery.md, in datasets/gallery/, of the sample scene and of data sets; the drawings go to
# build/gallery. Sets that are not there are named, and their pictures stay as they are. Prints what the captions say.
#
#   scripts/gallery/make_pictures.sh [folder of the data sets, ../shared/data] [mixed room pavilion herz-jesu-p8 vase, all]
#
# Needs the build and, by scripts/setup.sh: python3-opencv librsvg2-bin.
set -euo pipefail
data=$(realpath -m "${1:-$(dirname "$0")/../../../shared/data}")
wanted=" ${*:2} "
cd "$(dirname "$0")/../.."

limn=$PWD/build/release/limn
here=$PWD/scripts/gallery
out=$PWD/build/gallery
pictures=$PWD/datasets/gallery
mkdir -p "$out" "$pictures"

# has <set> <workspace>: whether its pictures are to be made, and can be.
has() {
  [[ $wanted =~ ^\ *$ || $wanted == *" $1 "* ]] || return 1
  [[ -d $2 ]] && return
  echo "SKIPPED: the pictures of $1: there is no folder $2 (datasets/README.md says where sets come from)"
  return 1
}

# draw <set> <workspace> [options]: into build/gallery/<set>, upright.
draw() {
  local set=$1 workspace=$2 seconds TIMEFORMAT=%U
  shift 2
  rm -rf "${out:?}/$set"
  seconds=$({ time $limn automatic_drawer --workspace_path "$workspace" --output_path "$out/$set" --align auto "$@" >"$out/$set.log"; } 2>&1)
  /usr/bin/python3 "$here/caption.py" "$set" "$out/$set/drawing.json" "$seconds"
}

# surfaces <set> <workspace>: that hide what is behind them.
surfaces() {
  $limn drawing_surfacer --workspace_path "$2" --output_path "$out/$1" --overwrite 1 >"$out/$1-surfaces.log"
}

# picture <name> <set> <workspace> <options of drawing_exporter> [-- photographs]: datasets/gallery/<name>.jpg.
picture() {
  local name=$1 set=$2 workspace=$3 options=()
  shift 3
  while (($#)) && [[ $1 != -- ]]; do options+=("$1") && shift; done
  shift $(($# > 0))
  $limn drawing_exporter --input_path "$out/$set/drawing.json" --workspace_path "$workspace" --output_path "$out/$name.svg" \
    --junctions 0 "${options[@]}" >"$out/$name.log"
  /usr/bin/python3 "$here/draw_picture.py" "$pictures/$name.jpg" "$out/$name.svg" "$@"
}

if has mixed datasets/sample/mixed; then
  set=datasets/sample/mixed
  draw mixed $set --box=-1.2,1.2,-0.9,0.9,0.01,1.1
  surfaces mixed $set
  picture mixed mixed $set --view view_07.jpg --hidden removed --dense_type faces --colors kind --line_width_px 1.2 \
    -- $set/images/view_0{6,7,8}.jpg
fi
if has room "$data/room"; then
  set=$data/room
  draw room "$set"
  surfaces room "$set"
  picture room room "$set" --view view_00.jpg --hidden removed --dense_type faces --colors kind --line_width_px 1.6 \
    -- "$set/images/view_00.jpg"
  picture room-plan room "$set" --section 1.2 --colors kind --detail coarse -- "$set"/images/view_{04,16,20}.jpg
fi
if has pavilion "$data/pavilion/midday"; then
  set=$data/pavilion/midday
  draw pavilion "$set"
  picture pavilion pavilion "$set" --view 0001.png --detail coarse --line_width_px 1 -- "$set/images/0001.png"
  picture pavilion-above pavilion "$set" --view axonometric --aligned 1 --detail coarse -- "$set"/images/00{17,49,65}.png
fi
if has herz-jesu-p8 "$data/herz-jesu-p8"; then
  set=$data/herz-jesu-p8
  draw herz-jesu-p8 "$set"
  picture herz-jesu herz-jesu-p8 "$set" --view 0004.jpg --detail coarse --line_width_px 1.5
  picture herz-jesu-front herz-jesu-p8 "$set" --view front --aligned 1 --detail coarse
fi
if has vase "$data/vase"; then
  set=$data/vase
  draw vase "$set"
  picture vase vase "$set" --view Img046_10.jpg --line_width_px 3 -- "$set/images/Img046_10.jpg"
fi
ls -l "$pictures"
