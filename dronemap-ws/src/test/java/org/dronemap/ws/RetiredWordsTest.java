package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Names of main code are free of the words in {@code config/retired-words.txt}. */
class RetiredWordsTest {
    private static final Path LIST = Path.of("..", "config", "retired-words.txt");

    @Test
    void standInNoNameOfMainCode() throws IOException {
        List<String> names = names(sources());

        assertThat(names).hasSizeGreaterThan(10_000);
        assertThat(names.stream().filter(name -> !retired(name).isEmpty())).isEmpty();
    }

    @Test
    void areFoundAsWordsOfAName() throws IOException {
        Path source = Files.createTempFile("Retired", ".java");
        try {
            Files.writeString(
                    source,
                    "record Desk(String voiceName) { interface Ticker { void lastHeard(); } enum Kind { TAKE }"
                            + " static int takeOffHand() { return 1; } void handOver(int told) {} Desk {} }");

            assertThat(names(List.of(source)).stream()
                            .map(name -> name.substring(name.indexOf(' ') + 1))
                            .filter(name -> !retired("- " + name).isEmpty()))
                    .containsExactly("Desk", "voiceName", "Ticker", "takeOffHand");
        } finally {
            Files.delete(source);
        }
    }

    /** Words of a name, which has its file before it, that it may not have. */
    private static List<String> retired(String fileAndName) {
        String name = fileAndName.substring(fileAndName.indexOf(' ') + 1);
        return Words.RETIRED.entrySet().stream()
                .filter(word -> has(name, word.getKey(), word.getValue()))
                .map(Map.Entry::getKey)
                .toList();
    }

    private static boolean has(String name, String word, List<String> allowed) {
        String rest = name;
        for (String phrase : allowed) {
            String capital = phrase.substring(0, 1).toUpperCase(Locale.ROOT) + phrase.substring(1);
            rest = rest.replace(phrase, "").replace(capital, "");
        }
        return Arrays.stream(rest.split("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|_"))
                .anyMatch(part -> part.equalsIgnoreCase(word));
    }

    private static List<String> names(List<Path> sources) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        List<String> names = new ArrayList<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null, files, null, List.of("-proc:none"), null, files.getJavaFileObjectsFromPaths(sources));
            for (CompilationUnitTree unit : task.parse()) {
                String file = Path.of(unit.getSourceFile().getName()).getFileName() + " ";
                new Names(file, names).scan(unit, null);
            }
        }
        return names;
    }

    /** Finds the names of types, methods and components of records, but for those that clients read and write. */
    private static final class Names extends TreeScanner<Void, Void> {
        private static final Pattern WIRE = Pattern.compile("\\w+(View|Request|Receipt|Message)\\.java ");

        private final String file;
        private final List<String> names;

        Names(String file, List<String> names) {
            this.file = file;
            this.names = names;
        }

        @Override
        public @Nullable Void visitClass(ClassTree type, @Nullable Void unused) {
            if (!type.getSimpleName().isEmpty()) {
                names.add(file + type.getSimpleName());
            }
            if (type.getKind() == Tree.Kind.RECORD && !WIRE.matcher(file).matches()) {
                type.getMembers().stream()
                        .filter(VariableTree.class::isInstance)
                        .map(VariableTree.class::cast)
                        .filter(member -> !member.getModifiers().getFlags().contains(Modifier.STATIC))
                        .forEach(member -> names.add(file + member.getName()));
            }
            return super.visitClass(type, unused);
        }

        @Override
        public @Nullable Void visitMethod(MethodTree method, @Nullable Void unused) {
            if (!method.getName().contentEquals("<init>")) {
                names.add(file + method.getName());
            }
            return super.visitMethod(method, unused);
        }
    }

    /** The list: each word with the phrases in which it may stand. */
    private static final class Words {
        private static final Map<String, List<String>> RETIRED = read();

        private static Map<String, List<String>> read() {
            Map<String, List<String>> words = new TreeMap<>();
            try {
                for (String line : Files.readAllLines(LIST)) {
                    if (!line.isBlank() && !line.startsWith("#")) {
                        String[] parts = line.split(": *", 2);
                        words.put(parts[0], parts.length == 1 ? List.of() : List.of(parts[1].split(", *")));
                    }
                }
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
            return words;
        }
    }

    private static List<Path> sources() throws IOException {
        List<Path> found = new ArrayList<>();
        try (Stream<Path> modules = Files.list(Path.of(".."))) {
            for (Path module : modules.filter(
                            path -> path.getFileName().toString().startsWith("dronemap-"))
                    .toList()) {
                Path main = module.resolve("src/main/java");
                if (Files.isDirectory(main)) {
                    try (Stream<Path> all = Files.walk(main)) {
                        all.filter(path -> path.toString().endsWith(".java")).forEach(found::add);
                    }
                }
            }
        }
        return found;
    }
}
