package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Comments of types begin with what the type is or does, and not with a question that they answer. */
class TypeCommentsTest {
    private static final Pattern COMMENT_OF_TYPE = Pattern.compile(
            "/\\*\\*((?:(?!\\*/).)*+)\\*/\\s*(?:@\\w+(?:\\((?:[^()]|\\([^()]*\\))*\\))?\\s*)*"
                    + "(?:(?:public|private|protected|static|final|abstract|sealed|non-sealed) )*(?:class|interface|record|enum|@interface) ",
            Pattern.DOTALL);
    private static final Pattern QUESTION =
            Pattern.compile("[\\s*]*(What|How|Who|Whom|Whose|Where|When|Whether|Why|Which)\\b.*", Pattern.DOTALL);

    @Test
    void beginWithWhatTheTypeIsOrDoes() throws IOException {
        List<Path> sources = sources();
        List<String> asking = new ArrayList<>();
        for (Path source : sources) {
            if (asks(Files.readString(source))) {
                asking.add(source.toString());
            }
        }
        assertThat(sources).hasSizeGreaterThan(1_000);
        assertThat(asking).isEmpty();
    }

    @Test
    void findsAQuestion() {
        assertThat(asks("/** What is kept. */\n@Stored(as = \"x\")\npublic record Kept() {}"))
                .isTrue();
        assertThat(asks("/**\n * How it is kept.\n */\nfinal class Keeping {}")).isTrue();
        assertThat(asks("/** A value that is kept. */\nrecord Kept() {}")).isFalse();
    }

    private static boolean asks(String source) {
        return COMMENT_OF_TYPE
                .matcher(source)
                .results()
                .anyMatch(comment -> QUESTION.matcher(comment.group(1)).matches());
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
                        all.filter(path -> path.toString().endsWith(".java") && !path.endsWith("package-info.java"))
                                .forEach(found::add);
                    }
                }
            }
        }
        return found;
    }
}
