#!/usr/bin/env bash
# Proof that a machine with nothing but Debian and git gets from a clone to a flying drone by the two commands:
# makes a clean Debian root (debootstrap), clones the committed state into it, and runs `up` and `test` there.
#
#   scripts/clean-machine.sh [--root DIR] [--suite NAME] [--keep] [--reuse] [--no-test] [--ready-within SECONDS] [--php]
#
# --root DIR   where the root is made (a new folder under /var/tmp)     --suite NAME  Debian release (bookworm)
# --keep       leaves the root for a look                               --reuse       takes the root that is there
# --no-test    only `up`, a second `up` and `down`
# --ready-within SECONDS   how fast the second `up` must be (30; more on a machine that has other work)
# --php        and, before all else, the PHP page: by `up --php`, by Apache, by nginx (see php-web-servers.sh)
# Needs root and debootstrap. The host's settings for package clients (proxies, mirrors, authorities) are carried in.
set -euo pipefail

SOURCE=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd)
CLEAN_ROOT=""
SUITE=bookworm
KEEP=false
REUSE=false
WITH_TEST=true
WITH_PHP=false
READY_WITHIN=30
# Variables by which package clients find proxies, mirrors and authorities, and the project's own settings.
readonly CARRIED='^(https?_proxy|no_proxy|all_proxy|HTTPS?_PROXY|NO_PROXY|ALL_PROXY|SSL_CERT_(FILE|DIR)|CURL_CA_BUNDLE|REQUESTS_CA_BUNDLE|NODE_EXTRA_CA_CERTS|GIT_SSL_CAINFO|PIP_[A-Z_]+|[Nn][Pp][Mm]_[Cc][Oo][Nn][Ff][Ii][Gg]_[A-Za-z_]+|MAVEN_OPTS|MAVEN_ARGS|JAVA_TOOL_OPTIONS|DRONEMAP_[A-Z_]+)$'

fail() {
    printf 'clean-machine: %s\n' "$*" >&2
    exit 1
}

read_options() {
    while (($# > 0)); do
        case $1 in
            --root) CLEAN_ROOT=${2:?--root needs a folder} && shift ;;
            --suite) SUITE=${2:?--suite needs a release} && shift ;;
            --keep) KEEP=true ;;
            --reuse) REUSE=true ;;
            --no-test) WITH_TEST=false ;;
            --php) WITH_PHP=true ;;
            --ready-within) READY_WITHIN=${2:?--ready-within needs seconds} && shift ;;
            *) fail "There is no option '$1'." ;;
        esac
        shift
    done
    ((EUID == 0)) || fail "Making a Debian root needs root rights."
    command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"
    CLEAN_ROOT=${CLEAN_ROOT:-$(mktemp -d /var/tmp/dronemap-clean.XXXXXX)}
}

# What the host's apt reads from Debian itself, as "site release component" lines; empty on another system.
# shellcheck disable=SC2016 # apt's own variables
debian_sources() {
    apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' "Codename: $SUITE" \
        2>/dev/null | sort -u
    apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' \
        2>/dev/null | awk -v suite="$SUITE-" 'index($2, suite) == 1' | sort -u
}

make_root() {
    local mirror
    mirror=$(debian_sources | awk -v suite="$SUITE" '$2 == suite { print $1; exit }')
    mkdir -p "$CLEAN_ROOT"
    # Web servers that run in it as another user must reach their files.
    chmod 711 "$CLEAN_ROOT"
    echo "== Making a clean Debian $SUITE in $CLEAN_ROOT"
    # Without a mirror debootstrap takes its own default.
    debootstrap --variant=minbase --include=git,ca-certificates "$SUITE" "$CLEAN_ROOT" ${mirror:+"$mirror"} >"$CLEAN_ROOT.log" 2>&1 ||
        fail "debootstrap failed; see $CLEAN_ROOT.log"
    carry_apt
    carry_authorities
}

carry_apt() {
    local sources
    sources=$(debian_sources | sort -u | awk '{ print "deb", $0 }')
    if [[ -n $sources ]]; then printf '%s\n' "$sources" >"$CLEAN_ROOT/etc/apt/sources.list"; fi
    # What matters for downloads (proxies, checks, retries), as the host's apt understands it.
    apt-config dump 2>/dev/null | grep -E '^Acquire::' | grep -vE '^Acquire::(IndexTargets|cdrom|Changelogs|Languages)' \
        >"$CLEAN_ROOT/etc/apt/apt.conf.d/90carried" || true
}

# Before anything is installed, so that Java's own trust store is made with them.
carry_authorities() {
    local file
    for file in /usr/local/share/ca-certificates/*.crt; do
        if [[ -e $file ]]; then install -D -m 644 "$file" "$CLEAN_ROOT$file"; fi
    done
    chroot "$CLEAN_ROOT" update-ca-certificates >/dev/null 2>&1 || fail "update-ca-certificates failed in $CLEAN_ROOT"
}

# Also for a root that is used again: settings of the host may have changed.
carry_settings() {
    local file home=$CLEAN_ROOT/root
    for file in /etc/resolv.conf /etc/hosts /etc/pip.conf; do
        if [[ -e $file ]]; then cp -L "$file" "$CLEAN_ROOT$file"; fi
    done
    for file in .npmrc .pip/pip.conf .config/pip/pip.conf .m2/settings.xml .m2/settings-security.xml; do
        if [[ -e $HOME/$file ]]; then install -D -m 600 "$HOME/$file" "$home/$file"; fi
    done
    carry_named_paths
}

# A variable may name a file or folder (an authority, a wheel folder) that the clean root has not.
carry_named_paths() {
    local value
    while IFS= read -r value; do
        if [[ $value == /* && -e $value && ! -e $CLEAN_ROOT$value ]]; then
            mkdir -p "$CLEAN_ROOT$(dirname "$value")"
            cp -aL "$value" "$CLEAN_ROOT$value"
        fi
    done < <(carried_variables | grep -v '^DRONEMAP_' | cut -d = -f 2-)
}

carried_variables() {
    local name
    while IFS= read -r name; do
        if [[ $name =~ $CARRIED ]]; then printf '%s=%s\n' "$name" "${!name}"; fi
    done < <(compgen -e)
}

# In namespaces of its own: what runs in there and what is mounted ends with it, however this ends.
run_inside() {
    local variables
    mapfile -t variables < <(carried_variables | grep -vE '^DRONEMAP_(TEST_DATA|DATA_DIR)=')
    export SOURCE CLEAN_ROOT WITH_TEST WITH_PHP READY_WITHIN
    unshare --mount --pid --fork --kill-child --propagation private \
        bash -euo pipefail -c "$(declare -f mount_inside inside_commands); mount_inside; inside_commands \"\$@\"" inside "${variables[@]}"
}

mount_inside() {
    mount -t proc proc "$CLEAN_ROOT/proc"
    mount --rbind /dev "$CLEAN_ROOT/dev"
    mount -t sysfs -o ro sysfs "$CLEAN_ROOT/sys"
    mkdir -p "$CLEAN_ROOT/mnt/source" "$CLEAN_ROOT/mnt/recordings"
    mount --bind -o ro "$SOURCE" "$CLEAN_ROOT/mnt/source"
    if [[ -d ${DRONEMAP_TEST_DATA:-} ]]; then mount --bind -o ro "$DRONEMAP_TEST_DATA" "$CLEAN_ROOT/mnt/recordings"; fi
}

# shellcheck disable=SC2016 # the inner shell's own variables
inside_commands() { # NAME=VALUE…
    local recordings=()
    if [[ -d ${DRONEMAP_TEST_DATA:-} ]]; then recordings=(DRONEMAP_TEST_DATA=/mnt/recordings); fi
    chroot "$CLEAN_ROOT" env -i HOME=/root TERM=dumb LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        "$@" "${recordings[@]}" WITH_TEST="$WITH_TEST" WITH_PHP="$WITH_PHP" READY_WITHIN="$READY_WITHIN" bash -euo pipefail -c '
        cd /root
        rm -rf dronemap
        git clone -q file:///mnt/source dronemap
        cd dronemap
        echo "== Clean clone of $(git log -1 --format="%h %s")"
        if [[ $WITH_PHP == true ]]; then
            echo "== ./dronemap up --php"
            ./dronemap up --php
            curl -fsS "http://127.0.0.1:${DRONEMAP_PHP_PORT:-8083}/" | grep -qi "<html" && echo "== The PHP page is reachable"
            curl -sS -H "Content-Type: application/json" -d "{\"user\": \"nobody\", \"password\": \"wrong\"}" \
                "http://127.0.0.1:${DRONEMAP_PHP_PORT:-8083}/session.php" | grep -q credentials-wrong
            scripts/php-web-servers.sh
            ./dronemap down
        fi
        echo "== ./dronemap up"
        time ./dronemap up
        ./dronemap status
        curl -fsS "http://127.0.0.1:${DRONEMAP_HTTP_PORT:-8080}/" | grep -qi "<html" && echo "== The page is reachable"
        ./dronemap down
        echo "== A second ./dronemap up"
        second=$SECONDS
        ./dronemap up
        second=$((SECONDS - second))
        echo "== Ready again after $second s"
        ((second < READY_WITHIN)) || { echo "That is more than $READY_WITHIN s." >&2; exit 1; }
        ./dronemap down
        if [[ $WITH_TEST == true ]]; then
            echo "== ./dronemap test"
            time ./dronemap test
        fi'
}

clean_up() {
    if [[ $KEEP == false && $REUSE == false ]]; then rm -rf --one-file-system "$CLEAN_ROOT" "$CLEAN_ROOT.log"; fi
}

read_options "$@"
trap clean_up EXIT
if [[ $REUSE == false || ! -x $CLEAN_ROOT/usr/bin/git ]]; then
    [[ ! -e $CLEAN_ROOT/usr ]] || fail "$CLEAN_ROOT holds a root already; choose another folder, or say --reuse."
    make_root
fi
carry_settings
run_inside
echo "== Both commands work on a clean Debian $SUITE"
