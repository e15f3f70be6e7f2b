# shellcheck shell=bash
# Shared by bullet_demos/run, tests/run and .ci/run: what is missing on a Debian is installed, then the tree is built.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${SHERD_BUILD:-$root/build}

# shellcheck disable=SC2034  # used by the scripts that source this file
build_packages=(build-essential cmake ninja-build pkg-config libbullet-dev libcgal-dev libsuitesparse-dev
  libopenblas-dev libeigen3-dev libcli11-dev libxxhash-dev nlohmann-json3-dev)
# shellcheck disable=SC2034
picture_packages=(povray webp)
# shellcheck disable=SC2034
viewer_packages=(libglfw3-dev libimgui-dev libepoxy-dev libstb-dev libassimp-dev libopenal-dev libgl1-mesa-dri libegl-mesa0
  libegl1)
# shellcheck disable=SC2034
test_packages=(libgtest-dev libassimp-dev clang python3 xvfb xauth doxygen)

say() { printf '%s\n' "$*" >&2; }
die() {
  say "$*"
  exit 1
}

# Prints those of the named packages that are not installed.
missing_packages() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s\n' "$package"
  done
}

# Installs those of the named packages that are not there. Does nothing, and takes no time, if all are.
install_packages() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "No apt-get here; on another system than Debian install what these packages hold by hand: $*"
    return
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      die "These packages are missing, and installing them takes root or sudo: ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq ||
    die "apt-get update failed (see above); is there a network connection?"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2 ||
    die "apt-get could not install: ${missing[*]} (see above)"
}

# in_turn COMMAND ...: while no other of these scripts configures or builds in the same folder.
in_turn() { flock "$build" "$@"; }

# configure [CMAKE ARGUMENT ...]: only if that was not done yet with the same arguments; ninja notices all other changes.
configure() {
  local stamp=$build/configured_with home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null) || true
  if [ "$home" ] && [ ! "$home" -ef "$root" ]; then
    die "$build was configured for $home: this tree was moved or copied. Remove $build and start again."
  fi
  if [ -f "$build/build.ninja" ] && [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$*" ]; then return; fi
  mkdir -p "$build"
  in_turn cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >"$build/configure.log" 2>&1 ||
    die "$(cat "$build/configure.log")"$'\n'"CMake could not configure $build (see above)."
  printf '%s' "$*" >"$stamp"
}

# add_option CMAKE_ARGUMENT ...: to a folder that is configured; what else it was configured with stays.
add_option() {
  in_turn cmake "$@" "$build" >"$build/configure.log" 2>&1 || die "$(cat "$build/configure.log")"$'\n'"CMake could not configure $build (see above)."
}

# tell_progress: of what ninja prints, how far it is, once a minute, and what the compiler says.
tell_progress() {
  local line percent told=$SECONDS
  while IFS= read -r line; do
    case $line in
      'ninja: no work to do.' | 'ninja: Entering directory '*) ;;
      '['*'%] '*)
        percent=${line#[}
        if ((SECONDS - told >= 60)); then say "built $((${percent%%%*})) %" && told=$SECONDS; fi
        ;;
      *) printf '%s\n' "$line" >&2 ;;
    esac
  done
}

# build_targets [TARGET ...]: prints what the compiler says only when it fails, and ninja's own line on a terminal; elsewhere
# a line that it builds, once that takes longer than a look at what is there, and then how far it is.
build_targets() {
  local notice= status=0
  if [ ! -t 2 ]; then
    (
      sleep 5 >/dev/null 2>&1
      say "building on $(nproc) cores; the first time this takes minutes"
    ) &
    notice=$!
  fi
  if [ "$notice" ]; then
    NINJA_STATUS='[%p] ' in_turn ninja -C "$build" "$@" 2>&1 | tell_progress || status=$?
  else
    in_turn ninja -C "$build" "$@" >&2 || status=$?
  fi
  if [ "$notice" ]; then { kill "$notice" && wait "$notice"; } 2>/dev/null || true; fi
  [ "$status" -eq 0 ] || die "The build in $build failed (see above)."
}

# OpenBLAS takes its oldest kernels on a processor that is newer than itself; these are right for all with AVX2.
if [ -z "${OPENBLAS_CORETYPE:-}" ] && grep -qs avx2 /proc/cpuinfo; then export OPENBLAS_CORETYPE=Haswell; fi
