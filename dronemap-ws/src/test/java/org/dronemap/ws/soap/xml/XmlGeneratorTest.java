package org.dronemap.ws.soap.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.annotation.JsonRawValue;
import java.time.Instant;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.json.JsonMapper;

/** What Jackson writes as JSON becomes elements by their types. */
class XmlGeneratorTest {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();
    private static final XmlType TEXT = XmlType.Text.of("string");
    private static final int ENOUGH = 10_000;

    private static XmlMember member(String name, XmlType type) {
        return new XmlMember(name, type, false, true, "");
    }

    private static final XmlTypes TYPES = new XmlTypes(Map.of(
            "Thing",
            new XmlTypes.Structure(
                    List.of(
                            member("name", TEXT),
                            member("height", XmlType.Text.of("double")),
                            member("at", XmlType.Text.of("dateTime")),
                            member("inner", new XmlType.Named("Thing")),
                            member("shape", new XmlType.Named("Shape")),
                            member("list", new XmlType.Listed(TEXT)),
                            member("map", new XmlType.Mapped(new XmlType.Plain()))),
                    ""),
            "Shape",
            new XmlTypes.Alternatives("kind", Map.of("circle", "Circle", "point", "Point"), ""),
            "Circle",
            new XmlTypes.Structure(List.of(member("radius", XmlType.Text.of("double"))), ""),
            "Point",
            new XmlTypes.Structure(List.of(), "")));

    private static @Nullable String written(XmlType type, Object value, int longest) {
        List<String> parts = XmlGenerator.write(MAPPER, TYPES, "return", type, value, longest);
        return parts == null ? null : String.join("", parts);
    }

    private static @Nullable String thing(Object value) {
        return written(new XmlType.Named("Thing"), value, ENOUGH);
    }

    private record Heading(
            String name,
            double height,
            @Nullable Instant at,
            @Nullable Object inner) {}

    @Test
    void writesMembersThatHaveAValue() {
        assertThat(thing(new Heading("a<b>&\"c\"\u0000\r", 12.5, Instant.EPOCH, new Heading("", 1e-5, null, null))))
                .isEqualTo("<return><name>a&lt;b&gt;&amp;\"c\"\uFFFD&#xd;</name><height>12.5</height>"
                        + "<at>1970-01-01T00:00:00Z</at><inner><name></name><height>1.0E-5</height></inner></return>");
    }

    @Test
    void tellsNoneFromEmptyAndNull() {
        assertThat(thing(Map.of("list", List.of()))).isEqualTo("<return><list/></return>");
        assertThat(thing(Map.of("list", Arrays.asList("a", null))))
                .isEqualTo(
                        "<return><list><item>a</item><item"
                                + " xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:nil=\"true\"/></list></return>");
        assertThat(thing(Map.of())).isEqualTo("<return/>");
    }

    @Test
    void saysWhatAnUntypedValueIs() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("a\"b", 1);
        map.put("c", true);
        map.put("d", "x");
        assertThat(thing(Map.of("map", map)))
                .isEqualTo("<return><map><entry key=\"a&quot;b\" type=\"number\">1</entry>"
                        + "<entry key=\"c\" type=\"boolean\">true</entry><entry key=\"d\" type=\"string\">x</entry></map>"
                        + "</return>");
    }

    private record Circle(String kind, double radius) {}

    private record Point(String kind) {}

    @Test
    void namesAnElementByItsAlternative() {
        assertThat(thing(Map.of("shape", new Circle("circle", 2))))
                .isEqualTo("<return><shape><circle><radius>2.0</radius></circle></shape></return>");
        assertThat(thing(Map.of("shape", new Point("point")))).isEqualTo("<return><shape><point/></shape></return>");
    }

    private record Backwards(double radius, String kind) {}

    @Test
    void refusesAnotherOrder() {
        assertThatThrownBy(() -> thing(Map.of("shape", new Backwards(2, "circle"))))
                .hasStackTraceContaining("begins with radius instead of kind");
        Map<String, Object> wrong = new LinkedHashMap<>();
        wrong.put("height", 1);
        wrong.put("name", "a");
        assertThatThrownBy(() -> thing(wrong)).hasStackTraceContaining("name is described before height");
    }

    private record Raw(@JsonRawValue String inner) {}

    @Test
    void readsWhatIsJsonAlready() {
        assertThat(thing(new Raw("{\"name\":\"a\",\"list\":[\"b\"]}")))
                .isEqualTo("<return><inner><name>a</name><list><item>b</item></list></inner></return>");
        assertThat(thing(MAPPER.readTree("{\"name\":\"a\",\"unknown\":{\"name\":[1,{\"x\":2}]},\"height\":1}")))
                .isEqualTo("<return><name>a</name><height>1</height></return>");
    }

    @Test
    void endsWhereItIsTooLong() {
        List<String> many = java.util.Collections.nCopies(100_000, "text");

        assertThat(written(new XmlType.Listed(TEXT), many, 1_000_000)).isNull();
        assertThat(written(new XmlType.Listed(TEXT), many, 2_000_000))
                .hasSize("<return></return>".length() + many.size() * "<item>text</item>".length());
    }
}
