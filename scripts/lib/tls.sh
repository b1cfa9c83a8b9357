# shellcheck shell=bash
# --public: TLS with an own or a generated certificate, and never with the first password.

# The one-time password stands in a file and in a terminal's history: good enough for loopback, not for a network.
refuse_first_password() {
    local advice="change it in the browser or with ./dronemap password, then run ./dronemap up --public."
    if [[ -e $FIRST_PASSWORD_FILE ]]; then
        if is_running server; then advice="At $(adopt_running_settings && local_address) $advice"; else advice="Run ./dronemap up, $advice"; fi
        fail "$EXIT_PASSWORD" "The administrator still has the one-time password, so it stays closed to the network. $advice"
    fi
    [[ -s $RUN_FILE ]] ||
        fail "$EXIT_PASSWORD" "No administrator's password was chosen yet, so it stays closed to the network. Run ./dronemap up, $advice"
}

provide_certificate() {
    [[ $PUBLIC == true ]] || return 0
    if [[ -z $CERTIFICATE ]]; then generate_certificate; fi
    command -v openssl >/dev/null || return 0
    openssl x509 -in "$CERTIFICATE" -noout 2>/dev/null || fail "$EXIT_USAGE" "'$CERTIFICATE' is not a certificate in PEM form."
    openssl pkey -in "$PRIVATE_KEY" -noout -passin pass: 2>/dev/null ||
        fail "$EXIT_USAGE" "'$PRIVATE_KEY' is not a private key in PEM form without a passphrase."
    [[ $(openssl x509 -in "$CERTIFICATE" -noout -pubkey) == "$(openssl pkey -in "$PRIVATE_KEY" -pubout)" ]] ||
        fail "$EXIT_USAGE" "The certificate '$CERTIFICATE' and the key '$PRIVATE_KEY' do not belong together."
    openssl x509 -in "$CERTIFICATE" -noout -checkend 0 >/dev/null || fail "$EXIT_USAGE" "The certificate '$CERTIFICATE' has expired."
}

# Signed by an authority of this machine's own, which each phone and browser is told to trust once: the certificate may then be
# renewed (in its last week, or when the machine has other names) without anybody's doing.
generate_certificate() {
    CERTIFICATE=$DATA/tls/certificate.pem
    PRIVATE_KEY=$DATA/tls/key.pem
    AUTHORITY=$DATA/tls/authority.pem
    command -v openssl >/dev/null || install_packages openssl
    local names
    names=$(certificate_names)
    if [[ $(cat "$DATA/tls/names" 2>/dev/null) == "$names" ]] && is_signed; then return; fi
    step "Generating a certificate"
    (umask 077 && mkdir -p "$DATA/tls")
    if ! { sign_certificate "$names" && is_signed; }; then
        # There is none yet, it has come to its end, or it may not sign for a name that the machine has now.
        if [[ -s $AUTHORITY ]]; then warn "A new authority signs from now on: tell phones and browsers to trust it, as the first time."; fi
        make_authority "$names" && sign_certificate "$names" && is_signed ||
            fail_from_log "$TOOLS/logs/tls.log" "$EXIT_FAILED" "No certificate could be generated."
    fi
    (umask 077 && printf '%s' "$names" >"$DATA/tls/names")
}

# The likeliest first: names that the owner gave, addresses on the network, the machine's own name, this machine.
certificate_names() {
    local name names="" given=${DRONEMAP_NAMES:-}
    for name in ${given//,/ }; do
        [[ $name =~ ^[A-Za-z0-9]([A-Za-z0-9.-]*[A-Za-z0-9])?$ ]] || fail "$EXIT_USAGE" "DRONEMAP_NAMES has '$name', which is no name of a machine."
        names+="DNS:$name,"
    done
    for name in $(hostname -I 2>/dev/null); do names+="IP:$name,"; done
    printf '%sDNS:%s,DNS:%s.local,DNS:localhost,IP:%s' "$names" "$(hostname)" "$(hostname -s)" "$LOOPBACK"
}

is_signed() {
    [[ -s $CERTIFICATE && -s $PRIVATE_KEY && -s $AUTHORITY ]] &&
        openssl x509 -in "$CERTIFICATE" -noout -checkend 604800 >/dev/null 2>&1 &&
        openssl verify -x509_strict -purpose sslserver -CAfile "$AUTHORITY" "$CERTIFICATE" >>"$TOOLS/logs/tls.log" 2>&1
}

# Good for local networks and for what the machine is called now; whoever steals its key can sign for nothing else.
make_authority() { # NAMES
    local permitted="permitted;DNS:local,permitted;DNS:lan,permitted;DNS:home.arpa,permitted;DNS:internal" name
    permitted+=",permitted;IP:10.0.0.0/255.0.0.0,permitted;IP:172.16.0.0/255.240.0.0,permitted;IP:192.168.0.0/255.255.0.0"
    permitted+=",permitted;IP:100.64.0.0/255.192.0.0,permitted;IP:169.254.0.0/255.255.0.0,permitted;IP:127.0.0.0/255.0.0.0"
    permitted+=",permitted;IP:fc00:0:0:0:0:0:0:0/fe00:0:0:0:0:0:0:0,permitted;IP:fe80:0:0:0:0:0:0:0/ffc0:0:0:0:0:0:0:0"
    for name in ${1//,/ }; do
        case $name in
            IP:*:*) permitted+=",permitted;$name/ffff:ffff:ffff:ffff:ffff:ffff:ffff:ffff" ;;
            IP:*) permitted+=",permitted;$name/255.255.255.255" ;;
            *) permitted+=",permitted;$name" ;;
        esac
    done
    (umask 077 && openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 3650 -sha256 \
        -keyout "$DATA/tls/authority-key.pem" -out "$AUTHORITY" -config <(
            printf '%s\n' '[req]' 'prompt=no' 'distinguished_name=who' 'x509_extensions=what' '[who]' "CN=Dronemap on $(hostname -s)" '[what]' \
                'basicConstraints=critical,CA:TRUE,pathlen:0' 'keyUsage=critical,keyCertSign,cRLSign' 'subjectKeyIdentifier=hash' "nameConstraints=critical,$permitted"
        )) >>"$TOOLS/logs/tls.log" 2>&1
}

sign_certificate() { # NAMES
    local key=$DATA/tls/authority-key.pem
    [[ -s $AUTHORITY && -s $key ]] || return 1
    (umask 077 && openssl req -new -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -subj "/O=Dronemap" \
        -keyout "$PRIVATE_KEY.new" -out "$DATA/tls/request.pem" &&
        openssl x509 -req -in "$DATA/tls/request.pem" -CA "$AUTHORITY" -CAkey "$key" -set_serial "0x$(openssl rand -hex 16)" -days 397 -sha256 \
            -out "$CERTIFICATE.new" -extfile <(
                printf '%s\n' 'basicConstraints=critical,CA:FALSE' 'keyUsage=critical,digitalSignature' 'extendedKeyUsage=serverAuth' \
                    'subjectKeyIdentifier=hash' 'authorityKeyIdentifier=keyid' "subjectAltName=$1"
            ) && mv "$PRIVATE_KEY.new" "$PRIVATE_KEY" && mv "$CERTIFICATE.new" "$CERTIFICATE") >>"$TOOLS/logs/tls.log" 2>&1
}

certificate_mark() {
    [[ $PUBLIC == true ]] || return 0
    sha256sum "$CERTIFICATE" | cut -c 1-16
}

fingerprint() { openssl x509 -in "${1:-$CERTIFICATE}" -noout -fingerprint -sha256 | sed 's/.*=//'; }
