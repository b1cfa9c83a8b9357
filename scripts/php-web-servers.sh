#!/usr/bin/env bash
# Proof that the lines of php-soap-proxy/README.md for Apache and nginx work, before a server that runs in this checkout.
# It installs packages and changes the system: only for a machine that is thrown away, as scripts/clean-machine.sh has one.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
readonly README=php-soap-proxy/README.md
export DEBIAN_FRONTEND=noninteractive

fail() {
    printf 'php-web-servers: %s\n' "$*" >&2
    exit 1
}

# The block of bash that has this text, without what needs systemd.
block_with() { # TEXT
    awk -v text="$1" '/^```bash$/ { block = ""; inside = 1; next }
        /^```$/ { if (inside && index(block, text)) { printf "%s", block; exit } inside = 0 }
        inside { block = block $0 "\n" }' "$README" | grep -v '^systemctl '
}

expect() { # TEXT WHAT
    [[ $2 == *"$1"* ]] || fail "'$1' was expected; it said: $2"
}

check() { # NAME
    local page=http://127.0.0.1:8084 told token jar
    jar=$(mktemp)
    # What README says to check, and what it says will come; once, as wrong passwords cost a rest.
    told=$(bash -c "$(block_with path-as-is)")
    expect $'200\n' "$told"
    expect proxy-signed-out "$told"
    expect credentials-wrong "$told"
    token=$(curl -s -c "$jar" -H 'Content-Type: application/json' -d "{\"key\": \"$(cat .data/local-key)\"}" "$page/session.php" |
        sed -nE 's/.*"token":"([0-9a-f]+)".*/\1/p')
    expect '"drones":[{' "$(curl -s -b "$jar" -H "X-Dronemap-Token: $token" "$page/proxy.php?operation=getDronesList")"
    expect drone-unknown "$(curl -s -b "$jar" -H "X-Dronemap-Token: $token" "$page/proxy.php?operation=getDrone&droneId=none")"
    expect proxy-token-wrong "$(curl -s -b "$jar" "$page/proxy.php?operation=getDronesList")"
    expect 404 "$(curl -s -o /dev/null -w '%{http_code}' "$page/page.html")"
    rm -f "$jar"
    echo "== $1 serves the PHP page"
}

# Else the lines would find what was there before them.
forget_web_servers() {
    rm -rf /opt/php-soap-proxy
    apt-get purge -y -q --auto-remove 'php*' 'libapache2*' 'apache2*' 'nginx*' >/dev/null
}

forget_web_servers
bash -euo pipefail -c "$(block_with 'apache2 libapache2-mod-php')"
apachectl restart
timeout 20 bash -c 'until curl -s -o /dev/null http://127.0.0.1:8084/; do sleep 0.2; done'
check Apache
apachectl stop
timeout 20 bash -c 'while curl -s -o /dev/null http://127.0.0.1:8084/; do sleep 0.2; done'

forget_web_servers
bash -euo pipefail -c "$(block_with 'nginx php-fpm')"
rm -f /etc/nginx/sites-enabled/default
mkdir -p /run/php
php-fpm8.2 --daemonize
nginx
timeout 20 bash -c 'until curl -s -o /dev/null http://127.0.0.1:8084/; do sleep 0.2; done'
check nginx
nginx -s stop
pkill php-fpm8.2
