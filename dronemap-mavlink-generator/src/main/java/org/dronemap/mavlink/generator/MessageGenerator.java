package org.dronemap.mavlink.generator;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The code generator run by the build: writes a Java record for each MAVLink message of the definition file. What is up
 * to date is not touched, so that nothing is compiled again because of it; what is defined no longer goes.
 */
public final class MessageGenerator {
    private static final String FOLDER = "org/dronemap/mavlink/message";

    private MessageGenerator() {}

    /** Takes the file of definitions and the folder of sources to write into, which nobody else writes into. */
    public static void main(String[] arguments) throws IOException {
        if (arguments.length != 2) {
            throw new IllegalArgumentException(
                    "wanted the file of definitions and the folder of sources, not " + arguments.length + " arguments");
        }
        generate(DefinitionReader.read(Path.of(arguments[0])), Path.of(arguments[1]));
    }

    static void generate(List<MessageDefinition> definitions, Path sources) throws IOException {
        Path folder = Files.createDirectories(sources.resolve(FOLDER));
        Set<Path> wanted = new HashSet<>();
        for (MessageDefinition definition : definitions) {
            Path file = folder.resolve(definition.recordName() + ".java");
            wanted.add(file);
            String source = JavaRecordSource.of(definition);
            if (!Files.exists(file) || !Files.readString(file).equals(source)) {
                Files.writeString(file, source);
            }
        }
        removeOthers(folder, wanted);
    }

    private static void removeOthers(Path folder, Set<Path> wanted) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(one -> !wanted.contains(one)).toList()) {
                Files.delete(file);
            }
        }
    }
}
