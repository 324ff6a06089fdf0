#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# lean_libraries.sh <folder>: build OpenCV, libtiff and Ceres as Limn needs them into <folder>/lib, from the sources of Debian's
# packages, to go with a program that is built against those packages. Debian's own use 140 other libraries, among them
# some under the GPL (poppler by GDAL, parts of SuiteSparse). Does nothing if they are there. Takes about 12 minutes on
# two cores; ccache, if installed, makes it a minute the next time.
set -euo pipefail
mkdir -p "$1"
folder=$(cd "$1" && pwd)
[[ -f $folder/done ]] && exit 0
command -v dpkg-source >/dev/null || { echo "ERROR: dpkg-source is missing (Debian: dpkg-dev)" >&2; exit 1; }

source "$(dirname "$0")/own_apt.sh"
own_apt "$folder/apt" deb-src "$(. /etc/os-release && echo "$VERSION_CODENAME")"
mkdir -p "$folder/sources"
# The versions of the packages that are installed.
version_of() { dpkg-query --show --showformat='${source:Version}' "$1"; }
cd "$folder/sources"
apt_get --download-only source "opencv=$(version_of libopencv-core-dev)" "ceres-solver=$(version_of libceres-dev)" "tiff=$(version_of libtiff6)"
rm -rf opencv ceres tiff
dpkg-source -x opencv_*.dsc opencv >/dev/null
dpkg-source -x ceres-solver_*.dsc ceres >/dev/null
dpkg-source -x tiff_*.dsc tiff >/dev/null

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
common=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_PREFIX="$folder"
  -DCMAKE_SKIP_RPATH=ON -Wno-dev "${launcher[@]}")
export CCACHE_BASEDIR=$folder CCACHE_NOHASHDIR=1

# Vector instructions as in Debian's package, so that results are the same.
cpu=()
[[ $(uname -m) != x86_64 ]] || cpu=(-DCPU_BASELINE=SSE2 -DCPU_BASELINE_DISABLE=SSE3)
off=(1394 ADE CAROTENE CUDA EIGEN FFMPEG GDAL GDCM GPHOTO2 GSTREAMER GTK IPP ITT
  JASPER LAPACK OPENCL OPENEXR OPENGL PROTOBUF QT QUIRC V4L VTK)
off=("${off[@]/#/-DWITH_}")
cmake -S opencv -B "$folder/build/opencv" "${common[@]}" "${cpu[@]}" "${off[@]/%/=OFF}" \
  -DBUILD_LIST=core,imgproc,imgcodecs -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF -DBUILD_JAVA=OFF -DBUILD_opencv_apps=OFF \
  -DBUILD_opencv_python2=OFF -DBUILD_opencv_python3=OFF -DENABLE_PRECOMPILED_HEADERS=OFF -DOPENCV_DOWNLOAD_TRIES_LIST= \
  -DBUILD_INFO_SKIP_TIMESTAMP=ON -DWITH_TBB=ON -DWITH_JPEG=ON -DWITH_PNG=ON -DWITH_TIFF=ON -DWITH_WEBP=ON -DWITH_OPENJPEG=ON
cmake --build "$folder/build/opencv" --target install
# Without JBIG, which is under the GPL: fax pages.
cmake -S tiff -B "$folder/build/tiff" "${common[@]}" -Djbig=OFF -Dtiff-tools=OFF -Dtiff-tests=OFF -Dtiff-contrib=OFF -Dtiff-docs=OFF
cmake --build "$folder/build/tiff" --target install
# Sparse systems are solved by Eigen, and none by Schur complements.
cmake -S ceres -B "$folder/build/ceres" "${common[@]}" -DBUILD_EXAMPLES=OFF -DBUILD_TESTING=OFF -DBUILD_BENCHMARKS=OFF \
  -DCUDA=OFF -DUSE_CUDA=OFF -DSUITESPARSE=OFF -DCXSPARSE=OFF -DLAPACK=OFF -DEIGENSPARSE=ON -DSCHUR_SPECIALIZATIONS=OFF
cmake --build "$folder/build/ceres" --target install
rm -rf "$folder/sources" "$folder/build" "$folder/apt"
touch "$folder/done"
