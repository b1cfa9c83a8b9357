package org.dronemap.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadDeserializer;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadSerializer;
import io.dronefleet.mavlink.util.EnumValue;
import java.lang.reflect.RecordComponent;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.dronemap.mavlink.dronefleet.OracleMessages;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every message record against dronefleet as an independent decoder and encoder, with random and extreme fields. */
class MessageRoundTripTest {
    private static final int ROUNDS = 200;

    private final Random random = new Random(42);

    static List<String> names() {
        return OracleMessages.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void readsAndWritesWhatDronefleetDoes(String name) throws ReflectiveOperationException {
        Class<?> oracle = OracleMessages.type(name);
        for (int round = 0; round < ROUNDS; round++) {
            byte[] payload = new ReflectionPayloadSerializer().serialize(oracleMessage(oracle, name));
            Object expected = new ReflectionPayloadDeserializer().deserialize(payload, oracle);

            Message decoded = decode(name, frame(payload, OracleMessages.type(name)));
            assertSameFields(decoded, expected);
            Frame second = readBack(new FrameWriter(1, 1, 2).frame(decoded));
            assertThat(second.payloadLength()).isEqualTo(trimmedLength(payload));
            assertThat(payloadOf(second)).isEqualTo(Arrays.copyOf(payload, trimmedLength(payload)));
            if (decoded.messageId() < 256) {
                int shortest = OracleMessages.shortestPayload(name);
                Frame first = readBack(new FrameWriter(1, 1, 1).frame(decoded));
                assertThat(payloadOf(first)).isEqualTo(Arrays.copyOf(payload, shortest));
                byte[] withoutExtensions = Arrays.copyOf(Arrays.copyOf(payload, shortest), payload.length);
                assertSameFields(
                        decode(name, first),
                        new ReflectionPayloadDeserializer().deserialize(withoutExtensions, oracle));
            }
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void decodesAnyPayloadWithoutFailing(String name) throws ReflectiveOperationException {
        for (int round = 0; round < ROUNDS; round++) {
            byte[] payload = new byte[1 + random.nextInt(255)];
            random.nextBytes(payload);
            Message decoded = decode(name, frame(payload, OracleMessages.type(name)));
            assertThat(decoded.toString()).isNotEmpty();
        }
    }

    /** Random payload octets as a message of the oracle; texts are printable, as the wire wants them. */
    private Object oracleMessage(Class<?> oracle, String name) {
        byte[] octets = new byte[OracleMessages.longestPayload(name)];
        if (random.nextInt(4) == 0) {
            Arrays.fill(octets, (byte) 0xFF);
        } else {
            random.nextBytes(octets);
        }
        if (random.nextBoolean()) {
            Arrays.fill(octets, random.nextInt(octets.length), octets.length, (byte) 0);
        }
        for (OracleMessages.Place text : OracleMessages.texts(name)) {
            int used = random.nextInt(text.length() + 1);
            for (int i = 0; i < text.length(); i++) {
                octets[text.offset() + i] = (byte) (i < used ? 'A' + random.nextInt(26) : 0);
            }
        }
        return new ReflectionPayloadDeserializer().deserialize(octets, oracle);
    }

    private static Frame frame(byte[] payload, Class<?> oracle) {
        int id = OracleMessages.id(oracle);
        byte[] raw = new byte[Frame.HEADER_2 + payload.length + 2];
        raw[0] = (byte) Frame.MAGIC_2;
        raw[1] = (byte) payload.length;
        raw[7] = (byte) id;
        raw[8] = (byte) (id >>> 8);
        System.arraycopy(payload, 0, raw, Frame.HEADER_2, payload.length);
        int crc =
                Crc.add(Crc.add(Crc.START, raw, 1, Frame.HEADER_2 - 1 + payload.length), MessageTable.checksumSeed(id));
        raw[raw.length - 2] = (byte) crc;
        raw[raw.length - 1] = (byte) (crc >>> 8);
        return readBack(raw);
    }

    private static Frame readBack(byte[] raw) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(raw), frames::add);
        assertThat(frames).hasSize(1);
        assertThat(frames.get(0).verified()).isTrue();
        return frames.get(0);
    }

    private static Message decode(String name, Frame frame) throws ReflectiveOperationException {
        return (Message) Class.forName("org.dronemap.mavlink.message." + name)
                .getMethod("decode", Frame.class)
                .invoke(null, frame);
    }

    private static void assertSameFields(Message decoded, Object expected) throws ReflectiveOperationException {
        for (RecordComponent component : decoded.getClass().getRecordComponents()) {
            Object mine = component.getAccessor().invoke(decoded);
            Object theirs = expected.getClass().getMethod(component.getName()).invoke(expected);
            assertThat(plain(mine, theirs instanceof EnumValue<?>))
                    .as("%s of %s", component.getName(), expected)
                    .isEqualTo(plain(theirs, false));
        }
    }

    /** Both sides in one form; dronefleet's enumerations hold 32 bit only, its octet arrays are signed. */
    private static Object plain(Object value, boolean low32) {
        if (value instanceof EnumValue<?> entry) {
            return List.of((long) entry.value());
        }
        if (value instanceof BigInteger big) {
            return List.of(big.longValue());
        }
        if (value instanceof Integer || value instanceof Long) {
            long number = ((Number) value).longValue();
            return List.of(low32 ? (long) (int) number : number);
        }
        return plainArray(value);
    }

    private static Object plainArray(Object value) {
        List<Object> elements = new ArrayList<>();
        if (value instanceof byte[] octets) {
            for (byte octet : octets) {
                elements.add(octet & 0xFFL);
            }
        } else if (value instanceof int[] numbers) {
            for (int number : numbers) {
                elements.add((long) number);
            }
        } else if (value instanceof float[] numbers) {
            for (float number : numbers) {
                elements.add(number);
            }
        } else if (value instanceof List<?> list) {
            for (Object element : list) {
                elements.add(element instanceof Integer number ? (Object) number.longValue() : element);
            }
        } else {
            return value;
        }
        return elements;
    }

    private static int trimmedLength(byte[] payload) {
        int length = payload.length;
        while (length > 1 && payload[length - 1] == 0) {
            length--;
        }
        return length;
    }

    private static byte[] payloadOf(Frame frame) {
        byte[] raw = frame.bytes();
        int header = frame.version() == 2 ? Frame.HEADER_2 : Frame.HEADER_1;
        return Arrays.copyOfRange(raw, header, header + frame.payloadLength());
    }
}
