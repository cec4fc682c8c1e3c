# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# An installed cbvh is found by find_package and builds a program, away from our sources and our build folder.
"$CMAKE" --install "$BUILD" --prefix "$SCRATCH/prefix" >install.log
cp -r "$SOURCE/tests/end_to_end/find_package" consumer
"$CMAKE" -S consumer -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_PREFIX_PATH="$SCRATCH/prefix" >configure.log
"$CMAKE" --build build
[[ $(build/consumer) == "1 triangle" ]]
if grep -rnF "$SOURCE" prefix/lib*/cmake; then
  echo "the installed package names the source folder"
  exit 1
fi
