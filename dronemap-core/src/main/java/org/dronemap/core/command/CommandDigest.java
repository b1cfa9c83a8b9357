package org.dronemap.core.command;

import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * SHA-256 digest of a command and its user, by which a retry under the same id is told from a different command. What
 * it is made of is read from the records themselves, so that no component is forgotten.
 */
public final class CommandDigest {
    private CommandDigest() {}

    /** {@code account}: whoever asks. */
    public static String of(String account, Command command) {
        StringBuilder text = new StringBuilder(command.kind().word());
        writeText(text, account);
        write(text, command);
        try {
            byte[] hash =
                    MessageDigest.getInstance("SHA-256").digest(text.toString().getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(hash);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    private static void write(StringBuilder text, @Nullable Object value) {
        if (value instanceof Record words) {
            writeRecord(text, words);
        } else if (value instanceof List<?> list) {
            text.append('[');
            list.forEach(each -> write(text, each));
            text.append(']');
        } else if (value instanceof Double number) {
            // Nothing flies differently for -0.0.
            writeText(text, Double.toString(number + 0.0));
        } else if (value instanceof Enum<?> name) {
            writeText(text, name.name());
        } else {
            writeText(text, String.valueOf(value));
        }
    }

    private static void writeRecord(StringBuilder text, Record words) {
        Stored stored = words.getClass().getAnnotation(Stored.class);
        text.append(stored == null ? "" : stored.as()).append('(');
        for (RecordComponent component : words.getClass().getRecordComponents()) {
            // Where the bytes of a log go, or who keeps something, is no part of what is asked.
            if (component.getType() != VehicleLogSink.class && component.getType() != ParameterOverrideRecorder.class) {
                write(text, component(words, component));
            }
        }
        text.append(')');
    }

    /** With its length, so that no text can look like two. */
    private static void writeText(StringBuilder text, String value) {
        text.append(value.length()).append(':').append(value);
    }

    private static @Nullable Object component(Record words, RecordComponent component) {
        try {
            return component.getAccessor().invoke(words);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(words.getClass() + " does not tell its " + component.getName(), e);
        }
    }
}
