package org.dronemap.mavlink.generator;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Reads the file that defines MAVLink messages, for the code generator. */
public final class DefinitionReader {
    private static final int LONGEST_PAYLOAD = 255;
    private static final Pattern MESSAGE = Pattern.compile("(\\d{1,8}) ([A-Z][A-Z0-9_]*)");
    private static final Pattern FIELD = Pattern.compile(" {4}([a-z0-9_]+)(?:\\[([1-9]\\d{0,2})])? ([a-z][a-z0-9_]*)");
    private static final String EXTENSIONS = "    extensions";

    private final List<MessageDefinition> definitions = new ArrayList<>();
    private final Set<String> seen = new HashSet<>();
    private @Nullable MessageDefinition message;
    private boolean extensions;

    private DefinitionReader() {}

    /**
     * All of {@code file}, in its order.
     *
     * @throws IllegalArgumentException for what is no definition; says which line, and what is wanted there
     */
    public static List<MessageDefinition> read(Path file) throws IOException {
        DefinitionReader reader = new DefinitionReader();
        int number = 0;
        for (String line : Files.readAllLines(file)) {
            number++;
            try {
                reader.parseLine(line);
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(file + ", line " + number + ": " + e.getMessage(), e);
            }
        }
        reader.endMessage();
        return List.copyOf(reader.definitions);
    }

    private void parseLine(String line) {
        Matcher head = MESSAGE.matcher(line);
        if (head.matches()) {
            begin(Integer.parseInt(head.group(1)), head.group(2));
        } else if (line.equals(EXTENSIONS) && message != null) {
            extensions = true;
        } else if (!line.isBlank() && !line.startsWith("#")) {
            parseField(line);
        }
    }

    private void begin(int id, String name) {
        endMessage();
        if (!seen.add(name) || !seen.add(Integer.toString(id))) {
            throw new IllegalArgumentException("the number " + id + " or the name " + name + " was there before");
        }
        message = new MessageDefinition(id, name, List.of());
        extensions = false;
    }

    private void endMessage() {
        if (message != null) {
            definitions.add(message);
        }
    }

    private void parseField(String line) {
        Matcher parts = FIELD.matcher(line);
        if (!parts.matches() || message == null) {
            throw new IllegalArgumentException("wanted \"NUMBER NAME\" of a message, or after it \"    TYPE name\" or"
                    + " \"    TYPE[ELEMENTS] name\" of a field or \"    extensions\", not \"" + line + "\"");
        }
        FieldType type = FieldType.find(parts.group(1))
                .orElseThrow(() -> new IllegalArgumentException(
                        "the type of a field is one of " + FieldType.known() + ", not " + parts.group(1)));
        int elements = parts.group(2) == null ? 0 : Integer.parseInt(parts.group(2));
        message = longer(message, new MessageField(type, elements, parts.group(3), extensions));
    }

    private static MessageDefinition longer(MessageDefinition message, MessageField field) {
        if (message.fields().stream().anyMatch(one -> one.name().equals(field.name()))) {
            throw new IllegalArgumentException(message.name() + " had a field " + field.name() + " before");
        }
        List<MessageField> fields = new ArrayList<>(message.fields());
        fields.add(field);
        MessageDefinition longer = new MessageDefinition(message.id(), message.name(), fields);
        if (longer.longestPayload() > LONGEST_PAYLOAD) {
            throw new IllegalArgumentException(
                    message.name() + " has at most " + LONGEST_PAYLOAD + " octets, not " + longer.longestPayload());
        }
        return longer;
    }
}
