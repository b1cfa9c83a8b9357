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

# Kept between starts, so that browsers and scripts that trusted it once go on trusting it; renewed in its last week.
generate_certificate() {
    CERTIFICATE=$DATA/tls/certificate.pem
    PRIVATE_KEY=$DATA/tls/key.pem
    command -v openssl >/dev/null || install_packages openssl
    if [[ -s $CERTIFICATE && -s $PRIVATE_KEY ]] && openssl x509 -in "$CERTIFICATE" -noout -checkend 604800 >/dev/null; then return; fi
    step "Generating a certificate"
    local names address
    names="DNS:localhost,DNS:$(hostname),IP:$LOOPBACK"
    for address in $(hostname -I 2>/dev/null); do names+=",IP:$address"; done
    (umask 077 && mkdir -p "$DATA/tls" &&
        openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 397 -subj "/CN=$(hostname)" \
            -addext "subjectAltName=$names" -keyout "$PRIVATE_KEY" -out "$CERTIFICATE" 2>"$TOOLS/logs/tls.log") ||
        fail_from_log "$TOOLS/logs/tls.log" "$EXIT_FAILED" "No certificate could be generated."
}

certificate_mark() {
    [[ $PUBLIC == true ]] || return 0
    sha256sum "$CERTIFICATE" | cut -c 1-16
}

fingerprint() { openssl x509 -in "$CERTIFICATE" -noout -fingerprint -sha256 | sed 's/.*=//'; }
