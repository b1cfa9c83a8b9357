package org.dronemap.ws.server;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLContext;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.settings.ServerSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.ssl.SslBundle;
import org.springframework.boot.ssl.pem.PemSslStoreBundle;
import org.springframework.boot.ssl.pem.PemSslStoreDetails;

/** TLS certificate of the WebSocket stream, reloaded within seconds when its files change. Any thread. */
public final class ReloadableCertificate {
    private static final Logger LOG = LoggerFactory.getLogger(ReloadableCertificate.class);
    private static final long BETWEEN_LOOKS_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final ServerSettings.Tls files;
    // all guarded by this
    private SSLContext context;
    private List<Object> marks;
    private long lookedNanos = System.nanoTime();

    private ReloadableCertificate(ServerSettings.Tls files) {
        this.files = files;
        this.marks = marks(files);
        this.context = read(files);
    }

    /** Reads it now; a certificate that cannot be used ends the start. */
    public static ReloadableCertificate of(ServerSettings.Tls files) {
        return new ReloadableCertificate(files);
    }

    /** As it is in the files, or was when they could last be read. */
    public synchronized SSLContext current() {
        long now = System.nanoTime();
        if (now - lookedNanos >= BETWEEN_LOOKS_NANOS) {
            lookedNanos = now;
            renew();
        }
        return context;
    }

    private void renew() {
        List<Object> seen = marks(files);
        if (seen.equals(marks)) {
            return;
        }
        try {
            context = read(files);
            marks = seen;
            LOG.info("The certificate {} is used from now on", files.certificate());
        } catch (SetupException e) {
            LOG.warn("{} The former one stays in use.", e.getMessage());
        }
    }

    private static List<Object> marks(ServerSettings.Tls files) {
        return List.of(mark(files.certificate()), mark(files.key()));
    }

    private static Object mark(Path file) {
        try {
            return List.of(Files.getLastModifiedTime(file), Files.size(file));
        } catch (IOException gone) {
            // read() says what is wrong with it
            return "";
        }
    }

    private static SSLContext read(ServerSettings.Tls files) {
        PemSslStoreDetails details =
                PemSslStoreDetails.forCertificate("file:" + files.certificate()).withPrivateKey("file:" + files.key());
        try {
            return SslBundle.of(new PemSslStoreBundle(details, null)).createSslContext();
        } catch (IllegalStateException | IllegalArgumentException e) {
            throw new SetupException(
                    "The certificate " + files.certificate() + " with the key " + files.key() + " cannot be used: "
                            + e.getMessage() + ".",
                    e);
        }
    }
}
