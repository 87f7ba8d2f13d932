# Debian 12 packages: what building the program needs, what the tests need besides, and
# what `cmake --build --preset tidy` needs.
packages_to_build=(
  g++ cmake ninja-build ccache pkg-config
  libeigen3-dev libboost-dev libyaml-cpp-dev libudunits2-dev
  libcairo2-dev fonts-dejavu-core nlohmann-json3-dev libcli11-dev
  libcgal-dev libnlopt-dev libsqlite3-dev
  libpugixml-dev libtomlplusplus-dev
)
packages_to_check=(
  libgtest-dev libgmock-dev libbenchmark-dev libslicot-dev libpng-dev libglpk-dev
  chromium libvalijson-dev
  pybind11-dev python3-dev python3-numpy python3-pytest dpkg-dev file
  libopenmpi-dev openmpi-bin
)
# What tests the explorer's page; any Node.js from 18 on will do. Users need none.
command -v npm >/dev/null || packages_to_check+=(nodejs npm)
packages_to_tidy=(clang-tidy)
