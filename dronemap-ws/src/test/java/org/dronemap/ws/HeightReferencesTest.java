package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Every height in the wire says what it is measured from: by its name, its description or a member beside it. */
class HeightReferencesTest {
    private static final Path DESCRIPTION = Path.of("src/test/resources/wire/openapi.json");
    private static final Pattern HEIGHT =
            Pattern.compile("altitude|height|floor|ceiling|elevation", Pattern.CASE_INSENSITIVE);
    private static final Pattern IN_NAME = Pattern.compile("amsl|above|relative", Pattern.CASE_INSENSITIVE);
    private static final Pattern IN_WORDS =
            Pattern.compile("home|sea level|amsl|ground|altitudeReference", Pattern.CASE_INSENSITIVE);
    /** Not a height but a size. */
    private static final Set<String> SIZES = Set.of("SensedMapView.height");

    @Test
    void eachHeightTellsWhatItIsMeasuredFrom() throws IOException {
        JsonNode schemas = JsonMapper.shared()
                .readTree(Files.readString(DESCRIPTION))
                .path("components")
                .path("schemas");
        List<String> silent = new ArrayList<>();
        int heights = 0;
        for (String name : schemas.propertyNames()) {
            JsonNode members = schemas.path(name).path("properties");
            boolean beside = members.propertyNames().stream().anyMatch(member -> member.endsWith("Reference"));
            for (String member : members.propertyNames()) {
                if (isNumber(members.path(member)) && HEIGHT.matcher(member).find()) {
                    heights++;
                    String words = members.path(member).path("description").asString("");
                    boolean told = beside
                            || IN_NAME.matcher(member).find()
                            || IN_WORDS.matcher(words).find();
                    String full = name + "." + member;
                    if (!told && !SIZES.contains(full)) {
                        silent.add(full);
                    }
                }
            }
        }

        assertThat(heights).isGreaterThan(20);
        assertThat(silent).isEmpty();
    }

    private static boolean isNumber(JsonNode member) {
        JsonNode type = member.path("type");
        return type.isArray()
                ? type.valueStream().anyMatch(each -> each.asString().equals("number"))
                : type.asString("").equals("number");
    }
}
