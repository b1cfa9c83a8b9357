package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.translate.DefinedMessage.Field;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every message that the product defines, with everything that a field can be which is no usual value, after it was
 * known: what tells a part of the state tells it anew, and no mark of the unknown is told as a value.
 */
class UnknownValuesTest {
    private static final Path SOURCES = Path.of("src/main/java/org/dronemap/proxy/mavlink/translate");
    private static final Pattern MESSAGE = Pattern.compile("org\\.dronemap\\.mavlink\\.message\\.([A-Z]\\w+)");
    private static final List<Number> USUAL = List.of(1, 2, 0);
    private static final List<Double> SCALES = List.of(1.0, 0.1, 0.01, 0.001, 1e-7, 0.2, 2.0);
    private static final List<String> LIMITS_OF_TYPES = List.of("uint8_t", "uint16_t", "int16_t", "int32_t", "float");
    /** What happened once, or carries its own time: it is not part of a state that could be old. */
    private static final Set<DroneEvent.Kind> NO_STATE = EnumSet.of(
            DroneEvent.Kind.PHOTO,
            DroneEvent.Kind.READING,
            DroneEvent.Kind.WIND,
            DroneEvent.Kind.TEXT,
            DroneEvent.Kind.MISSION_ITEM_REACHED,
            DroneEvent.Kind.OUTPUTS);
    /** Numbers that may be as large as their type lets them. */
    private static final Set<String> COUNTS = Set.of(
            "BATTERY_STATUS.id",
            "CAMERA_FEEDBACK.img_idx",
            "CAMERA_IMAGE_CAPTURED.image_index",
            "NAMED_VALUE_FLOAT.value");

    static Stream<DefinedMessage> messages() {
        return DefinedMessage.all().stream();
    }

    private static List<DroneEvent> told(int autopilot, Message... messages) {
        List<DroneEvent> events = new ArrayList<>();
        Heartbeat flying = new Heartbeat(2, autopilot, 0x81, 4, 4, 3);
        TelemetryTranslator translator =
                new TelemetryTranslator(AutopilotAdapter.of(flying), new VehicleStatus(2, 0), events::add);
        long now = 1_000_000_000L;
        translator.received(VehicleFrames.of(1, flying), now);
        for (Message message : messages) {
            events.clear();
            now += 20_000_000L;
            translator.received(VehicleFrames.of(1, message), now);
            translator.receivedFromComponent(VehicleFrames.of(2, message), now);
        }
        return List.copyOf(events);
    }

    private static Set<DroneEvent.Kind> kinds(Collection<DroneEvent> events) {
        Set<DroneEvent.Kind> kinds = EnumSet.noneOf(DroneEvent.Kind.class);
        events.forEach(event -> kinds.add(event.kind()));
        kinds.removeAll(NO_STATE);
        return kinds;
    }

    @ParameterizedTest
    @MethodSource("messages")
    void nothingOldAndNoMarkOfTheUnknownIsToldAsNow(DefinedMessage message) {
        for (int autopilot : List.of(3, 12)) {
            Number usual = USUAL.stream()
                    .max(Comparator.comparing(
                            number -> told(autopilot, message.of(number)).size()))
                    .orElseThrow();
            Message known = message.of(usual);
            Set<DroneEvent.Kind> before = kinds(told(autopilot, known));
            for (Field field : message.fields()) {
                for (Number extreme : field.extremes()) {
                    Message odd = message.with(usual, field, extreme);
                    List<DroneEvent> events = told(autopilot, known, odd);
                    String what = message.name() + "." + field.name() + " = " + extreme + ", others " + usual;
                    if (!isAnotherThing(message, field)) {
                        assertThat(kinds(events)).as(what).containsAll(before);
                    }
                    events.forEach(event -> isSensible(what, message, field, extreme, event));
                }
            }
        }
    }

    /** Numbers the thing that the message is about, or says what it tells. */
    private static boolean isAnotherThing(DefinedMessage message, Field field) {
        // By its type a heartbeat is a ground station's or a gimbal's, and none of the vehicle.
        boolean sender = message.name().equals("HEARTBEAT") && field.name().equals("type");
        return sender || Set.of("port", "system_status").contains(field.name());
    }

    private static void isSensible(String what, DefinedMessage message, Field field, Number extreme, DroneEvent event) {
        boolean count = COUNTS.contains(message.name() + "." + field.name());
        for (double number : numbers(event)) {
            assertThat(number).as(what + ": " + event).isFinite();
            boolean limit = extreme.equals(field.extremes().get(0)) || Math.abs(extreme.doubleValue()) > 1e30;
            if (!count && limit && LIMITS_OF_TYPES.contains(field.type())) {
                for (double scale : SCALES) {
                    assertThat(Math.abs(number - extreme.doubleValue() * scale))
                            .as(what + ": " + event)
                            .isNotCloseTo(0, org.assertj.core.data.Offset.offset(1e-9));
                }
            }
        }
    }

    private static List<Double> numbers(Object value) {
        List<Double> found = new ArrayList<>();
        if (value instanceof Number number) {
            found.add(number.doubleValue());
        } else if (value instanceof Collection<?> many) {
            many.forEach(one -> found.addAll(numbers(one)));
        } else if (value instanceof Record whole && !(value instanceof DroneEvent.Identified)) {
            for (RecordComponent part : whole.getClass().getRecordComponents()) {
                try {
                    Object read = part.getAccessor().invoke(whole);
                    if (read != null) {
                        found.addAll(numbers(read));
                    }
                } catch (ReflectiveOperationException e) {
                    throw new AssertionError(e);
                }
            }
        }
        return found;
    }

    /** A message that is translated and tells nothing with any usual value would not be tested above. */
    @Test
    void everyMessageThatIsTranslatedTellsSomething() throws IOException {
        Set<String> translated = new TreeSet<>();
        for (String source : List.of("TelemetryTranslator", "PayloadTranslator", "HighLatencyTranslator")) {
            Matcher names = MESSAGE.matcher(Files.readString(SOURCES.resolve(source + ".java")));
            while (names.find()) {
                translated.add(names.group(1));
            }
        }
        Set<String> telling = new TreeSet<>();
        messages()
                .filter(message -> USUAL.stream()
                        .anyMatch(usual -> !told(3, message.of(usual)).isEmpty()))
                .forEach(message -> telling.add(message.recordName()));
        // Empty in the pieces of long sentences, which StatustextJoinerTest is about.
        translated.remove("Statustext");
        assertThat(telling).hasSizeGreaterThan(12).containsAll(translated);
    }
}
