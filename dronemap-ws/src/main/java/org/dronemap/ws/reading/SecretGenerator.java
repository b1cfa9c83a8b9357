package org.dronemap.ws.reading;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.HexFormat;

/** Generates random passwords and 256-bit tokens, and the hashes under which tokens are stored. Any thread. */
public final class SecretGenerator {
    private static final int BYTES = 32;
    private static final String READABLE = "abcdefghijkmnpqrstuvwxyz23456789";

    private final SecureRandom random = new SecureRandom();

    /** 256 random bits in URL-safe letters. */
    public String token() {
        byte[] bytes = new byte[BYTES];
        random.nextBytes(bytes);
        return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
    }

    /** A password that can be read out: 20 letters and digits (100 bits), none that looks like another. */
    public String password() {
        StringBuilder text = new StringBuilder();
        for (int index = 0; index < 20; index++) {
            if (index > 0 && index % 5 == 0) {
                text.append('-');
            }
            text.append(READABLE.charAt(random.nextInt(READABLE.length())));
        }
        return text.toString();
    }

    /** SHA-256 in hexadecimal; enough for a secret of 256 random bits, not for a password. */
    public static String hash(String token) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(token.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
