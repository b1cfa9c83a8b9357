package org.dronemap.ws.plainhttp;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * The private certificate authority that signed this server's certificate, which phones must be made to trust.
 *
 * @param certificate in DER form
 * @param fingerprint SHA-256, in pairs of digits
 * @param names by which the server may be called, names and addresses; the likeliest first
 */
record LocalCertificateAuthority(X509Certificate certificate, String fingerprint, List<String> names) {
    private static final int DNS = 2;
    private static final int ADDRESS = 7;

    /** {@code server}: the certificate that it signed; both as PEM. */
    static LocalCertificateAuthority read(Path authority, Path server) throws IOException {
        try {
            X509Certificate certificate = certificate(authority);
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(certificate.getEncoded());
            return new LocalCertificateAuthority(
                    certificate,
                    HexFormat.ofDelimiter(":").withUpperCase().formatHex(digest),
                    names(certificate(server)));
        } catch (GeneralSecurityException e) {
            throw new IOException("The certificate " + authority + " cannot be read: " + e.getMessage(), e);
        }
    }

    /** What another machine can reach it by; empty lists name nothing but this machine. */
    String name() {
        return names.stream().filter(name -> !isOwn(name)).findFirst().orElse("localhost");
    }

    /** By which it was called, where that is one of its names that others can use, too; else the likeliest. */
    String nameFor(String called) {
        String name = called.toLowerCase(Locale.ROOT);
        return names.contains(name) && !isOwn(name) ? name : name();
    }

    private static boolean isOwn(String name) {
        return name.equals("localhost") || name.startsWith("127.") || name.equals("::1");
    }

    private static X509Certificate certificate(Path file) throws IOException, CertificateException {
        try (InputStream in = Files.newInputStream(file)) {
            return (X509Certificate) CertificateFactory.getInstance("X.509").generateCertificate(in);
        }
    }

    private static List<String> names(X509Certificate server) throws CertificateException {
        Collection<List<?>> all = server.getSubjectAlternativeNames();
        return all == null
                ? List.of()
                : all.stream()
                        .filter(one -> Objects.equals(one.get(0), DNS) || Objects.equals(one.get(0), ADDRESS))
                        .map(one -> plain((String) one.get(1)))
                        .toList();
    }

    /** As people write it: Java spells IPv6 addresses out. */
    private static String plain(String name) {
        if (!name.contains(":")) {
            return name.toLowerCase(Locale.ROOT);
        }
        try {
            return InetAddress.getByName(name).getHostAddress();
        } catch (UnknownHostException e) {
            throw new IllegalStateException("a certificate has an address that is none: " + name, e);
        }
    }
}
