# Shared by ./delos and ./check: install what is missing, configure, build.
# Expects `root`, the project's folder.

source "$root/cmake/packages.sh"

# What ccache must overlook to keep precompiled headers.
export CCACHE_SLOPPINESS=pch_defines,time_macros
# A second clone shares what the first one compiled.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# install_missing PACKAGE...: as root, or with sudo; else print the line to run.
install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' ||
      missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
      as_root=(sudo)
    else
      echo "Delos needs packages that only an administrator can install:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
  fi
  echo "Installing ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build PRESET TARGET...: configure once, then build; ccache makes the second time short.
build() {
  local preset=$1
  shift
  [ -f "$root/build/$preset/build.ninja" ] ||
    cmake -S "$root" --preset "$preset" "${configure_options[@]}" >&2
  cmake --build "$root/build/$preset" --target "$@" >&2
}
