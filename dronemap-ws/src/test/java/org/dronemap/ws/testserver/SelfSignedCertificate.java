package org.dronemap.ws.testserver;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.X509Certificate;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.dronemap.ws.settings.ServerSettings;

/** A certificate that this machine makes for itself, in PEM files, and a client's trust in it. */
public final class SelfSignedCertificate {
    private static final char[] PASSWORD = "changeit".toCharArray();

    private final X509Certificate certificate;

    private SelfSignedCertificate(X509Certificate certificate) {
        this.certificate = certificate;
    }

    /** Writes a new one over what is there. */
    public static SelfSignedCertificate make(Path directory) {
        try {
            Path store = Files.createTempFile(directory, "made", ".p12");
            Files.delete(store);
            run(store);
            KeyStore keys = KeyStore.getInstance("PKCS12");
            keys.load(new ByteArrayInputStream(Files.readAllBytes(store)), PASSWORD);
            X509Certificate made = (X509Certificate) keys.getCertificate("own");
            write(
                    directory.resolve("key.pem"),
                    "PRIVATE KEY",
                    keys.getKey("own", PASSWORD).getEncoded());
            write(directory.resolve("certificate.pem"), "CERTIFICATE", made.getEncoded());
            return new SelfSignedCertificate(made);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void run(Path store) throws IOException {
        List<String> command = List.of(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                "-genkeypair",
                "-alias",
                "own",
                "-keyalg",
                "EC",
                "-groupname",
                "secp256r1",
                "-validity",
                "30",
                "-dname",
                "CN=localhost",
                "-ext",
                "san=dns:localhost,ip:127.0.0.1",
                "-storetype",
                "PKCS12",
                "-keystore",
                store.toString(),
                "-storepass",
                new String(PASSWORD));
        Process made = new ProcessBuilder(command).redirectErrorStream(true).start();
        try {
            if (!made.waitFor(60, TimeUnit.SECONDS) || made.exitValue() != 0) {
                throw new IllegalStateException(
                        new String(made.getInputStream().readAllBytes(), java.nio.charset.StandardCharsets.UTF_8));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void write(Path file, String what, byte[] bytes) throws IOException {
        String text = "-----BEGIN " + what + "-----\n"
                + Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes) + "\n-----END " + what + "-----\n";
        Files.writeString(file, text);
    }

    public static ServerSettings.Tls files(Path directory) {
        return new ServerSettings.Tls(directory.resolve("certificate.pem"), directory.resolve("key.pem"));
    }

    public X509Certificate certificate() {
        return certificate;
    }

    /** Of a client that trusts this one and no other. */
    public SSLContext trust() {
        try {
            KeyStore known = KeyStore.getInstance("PKCS12");
            known.load(null, null);
            known.setCertificateEntry("own", certificate);
            TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            trust.init(known);
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(null, trust.getTrustManagers(), null);
            return context;
        } catch (GeneralSecurityException | IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
