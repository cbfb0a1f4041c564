# Sourced by ./run and ./test: installs what is missing, configures and builds. The one list of Debian packages is here.

# To configure and build.
BUILD_PACKAGES=(
    g++ cmake ninja-build pkg-config glslang-tools
    libvulkan-dev libglfw3-dev libimgui-dev libglm-dev libfmt-dev libcli11-dev nlohmann-json3-dev
    libtinygltf-dev libstb-dev libopenexr-dev zlib1g-dev liberfa-dev libembree-dev libgtest-dev
    libdraco-dev libmeshoptimizer-dev libwebp-dev
)
# To run the program: a Vulkan driver for machines without a GPU, and with most of those.
RUN_PACKAGES=(mesa-vulkan-drivers)
# To run the tests: validation, and a window without a display.
TEST_PACKAGES=(vulkan-validationlayers xvfb xdotool)

BUILD_FOLDER=out/build/release
BUILD_LOG=out/build/release.log

say() { printf '%s\n' "$*" >&2; }
stop() { say "$(basename "$0"): $*"; exit 1; }

# Prints those of the packages $@ that are not installed.
missing_packages() {
    local installed
    installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "$@" 2>/dev/null) "
    local package
    for package in "$@"; do
        [[ $installed == *" installed:$package "* ]] || printf '%s ' "$package"
    done
}

install_missing() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        check_tools "$@"
        return
    fi
    local missing as_root=()
    read -ra missing <<<"$(missing_packages "$@")"
    ((${#missing[@]})) || return 0
    say "installing ${#missing[@]} Debian packages: ${missing[*]}"
    if ((EUID != 0)); then
        command -v sudo >/dev/null || stop "sudo is not there; as root, run: apt-get install ${missing[*]}"
        as_root=(sudo)
    fi
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Acquire::Retries=2 -o Dpkg::Use-Pty=0)
    mkdir -p out/build
    local log=out/build/packages.log
    "${apt[@]}" update >"$log" 2>&1 || say "warning: the package lists could not be renewed (see $log); going on with the old ones"
    if ! "${apt[@]}" install --no-install-recommends "${missing[@]}" >>"$log" 2>&1; then
        tail -n 15 "$log" >&2
        stop "the packages could not be installed: is there a network? (log: $log; by hand: apt-get install ${missing[*]})"
    fi
}

# Where there is no apt-get: says what is needed, and goes on where the tools are there; CMake looks for the libraries.
check_tools() {
    [[ -e $BUILD_FOLDER/build.ninja ]] && return
    say "this is not Debian; needed are the likes of these packages: $*"
    local tool
    for tool in c++ cmake ninja pkg-config glslangValidator; do
        command -v "$tool" >/dev/null || stop "$tool is not there; install it, then run this again"
    done
}

configure() {
    # A build folder that was made for another place would build the sources there.
    if [[ -e $BUILD_FOLDER/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$BUILD_FOLDER/CMakeCache.txt"; then
        rm -rf "$BUILD_FOLDER"
    fi
    [[ -e $BUILD_FOLDER/build.ninja ]] && return
    command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
    say "configuring"
    if ! cmake --preset release >"$BUILD_LOG" 2>&1; then
        cat "$BUILD_LOG" >&2
        stop "the build could not be configured (log: $BUILD_LOG)"
    fi
}

# Reads ninja's lines and shows how far it is: on a terminal in one line, elsewhere every ten seconds.
show_progress() {
    local line shown=-10 open=
    while IFS= read -r line; do
        [[ $line =~ ^\[([1-9][0-9]*)/([0-9]+)\]\ (.*) ]] || continue
        [[ ${BASH_REMATCH[3]} == "Re-running CMake"* ]] && continue
        if [[ -t 2 ]]; then
            printf '\rbuilding %s of %s  ' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
            open=1
        elif ((SECONDS - shown >= 10)); then
            say "building ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
            shown=$SECONDS
        fi
    done
    [[ -z $open ]] || printf '\n' >&2
}

# build TARGET…
build() {
    if ! cmake --build "$BUILD_FOLDER" --target "$@" 2>&1 | tee "$BUILD_LOG" | show_progress; then
        grep -vE '^\[[0-9]+/[0-9]+\] ' "$BUILD_LOG" >&2
        stop "the build failed (log: $BUILD_LOG)"
    fi
}

# set_up "PACKAGE…" TARGET…: everything up to the built targets. One set-up at a time; another waits.
set_up() {
    local packages
    read -ra packages <<<"$1"
    shift
    mkdir -p out/build
    exec 9>out/build/.lock
    flock -n 9 || { say "waiting for another build"; flock 9; }
    install_missing "${packages[@]}"
    configure
    build "$@"
    exec 9>&-
}
