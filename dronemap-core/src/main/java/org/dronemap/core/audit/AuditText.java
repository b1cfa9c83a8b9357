package org.dronemap.core.audit;

import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Cleans texts for audit records: one line, bounded length, secrets hidden, the same after being read back. */
public final class AuditText {
    private static final String HIDDEN = "[hidden]";
    /** So many letters and digits in a row that nobody means them as a word; or a password as servers here make them. */
    private static final Pattern SECRET = Pattern.compile("[A-Za-z0-9_+/=-]{40,}|\\b(?:[a-z2-9]{5}-){3}[a-z2-9]{5}\\b");

    private AuditText() {}

    /** Cut to so many characters; control characters and broken surrogates become U+FFFD. */
    public static String of(String text, int longest) {
        StringBuilder plain = new StringBuilder(Math.min(text.length(), longest));
        text.codePoints()
                .limit(longest)
                .map(point -> Character.isISOControl(point) || isSurrogate(point) ? 0xFFFD : point)
                .forEach(plain::appendCodePoint);
        return plain.toString();
    }

    static @Nullable String orNull(@Nullable String text, int longest) {
        return text == null ? null : of(text, longest);
    }

    /** Hides what looks like a key, a token or a password that a server made. */
    public static String withoutSecrets(String text) {
        return SECRET.matcher(text).replaceAll(HIDDEN);
    }

    static @Nullable String withoutSecretsOrNull(@Nullable String text) {
        return text == null ? null : withoutSecrets(text);
    }

    private static boolean isSurrogate(int point) {
        return point >= Character.MIN_SURROGATE && point <= Character.MAX_SURROGATE;
    }
}
