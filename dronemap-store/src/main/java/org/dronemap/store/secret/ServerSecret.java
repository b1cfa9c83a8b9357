package org.dronemap.store.secret;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
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
            if (Files.notExists(file)) {
                create(file);
            }
            return box(Files.readString(file), "The server's secret in " + file);
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

    private static void create(Path file) throws IOException {
        byte[] random = new byte[SecretBox.SECRET_BYTES];
        new SecureRandom().nextBytes(random);
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        Files.deleteIfExists(fresh);
        Files.createFile(fresh, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
        Files.writeString(fresh, HexFormat.of().formatHex(random));
        try (FileChannel channel = FileChannel.open(fresh, StandardOpenOption.WRITE)) {
            channel.force(true);
        }
        Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE);
    }
}
