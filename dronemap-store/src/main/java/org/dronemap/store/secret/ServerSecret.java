package org.dronemap.store.secret;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HexFormat;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;

/**
 * The two secrets of this server, one for stored keys and one for the audit log: given as settings, or kept in files.
 */
public final class ServerSecret {
    private static final String FORM = "[0-9a-fA-F]{64}";

    private ServerSecret() {}

    /** Seals keys with the given secret (64 hexadecimal digits), or the file's, which is made at the first start. */
    public static SecretBox box(@Nullable String given, Path file) {
        return new SecretBox(bytes(given, file, "The server's secret"));
    }

    /** Seals records of what was done; the key is given or kept likewise. */
    public static HmacKeyedHash seal(@Nullable String given, Path file) {
        return new HmacKeyedHash(bytes(given, file, "The key of the audit log"));
    }

    private static byte[] bytes(@Nullable String given, Path file, String what) {
        if (given != null) {
            return bytes(given, what + " that was given");
        }
        try {
            return bytes(RandomFile.readOrCreate(file, SecretBox.SECRET_BYTES), what + " in " + file);
        } catch (IOException e) {
            throw new StoreException(what + " cannot be kept in " + file + ": " + e.getMessage(), e);
        }
    }

    private static byte[] bytes(String text, String what) {
        String digits = text.strip();
        if (!digits.matches(FORM)) {
            throw new StoreException(what + " must be 64 hexadecimal digits; it has " + digits.length()
                    + " characters or others than those.");
        }
        return HexFormat.of().parseHex(digits);
    }
}
