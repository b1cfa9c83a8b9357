package org.dronemap.store.secret;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HexFormat;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;

/** The secret that seals what is stored: given from outside, or a file that only its owner reads. */
public final class ServerSecret {
    private static final String FORM = "[0-9a-fA-F]{64}";

    private ServerSecret() {}

    /** The given secret (64 hexadecimal digits), or the file's, which is made at the first start. */
    public static SecretBox box(@Nullable String given, Path file) {
        if (given != null) {
            return box(given, "The server's secret that was given");
        }
        try {
            return box(RandomFile.readOrCreate(file, SecretBox.SECRET_BYTES), "The server's secret in " + file);
        } catch (IOException e) {
            throw new StoreException("The server's secret cannot be kept in " + file + ": " + e.getMessage(), e);
        }
    }

    private static SecretBox box(String text, String what) {
        String digits = text.strip();
        if (!digits.matches(FORM)) {
            throw new StoreException(what + " must be 64 hexadecimal digits; it has " + digits.length()
                    + " characters or others than those.");
        }
        return new SecretBox(HexFormat.of().parseHex(digits));
    }
}
