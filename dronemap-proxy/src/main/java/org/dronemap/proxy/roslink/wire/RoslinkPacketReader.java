package org.dronemap.proxy.roslink.wire;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import org.dronemap.proxy.roslink.wire.PacketReadResult.Fault;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamFactory;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Parses ROSLink messages from robots, in both layouts and leniently; errors are results, not exceptions. Thread-safe.
 */
public final class RoslinkPacketReader {
    /** Twice the largest image that bridges send, in Base64. */
    public static final int LONGEST_BYTES = 600_000;

    private static final int DEEPEST = 8;
    private static final int MOST_TOKENS = 40_000;
    private static final int LONGEST_NAME = 100;
    private static final int LONGEST_NUMBER = 64;
    private static final int LARGEST_SYSTEM_ID = 65_535;
    private static final int LARGEST_MESSAGE_ID = 65_535;

    /** Names are the sender's choice: nothing of them is kept. Python writes NaN and Infinity. */
    private static final JsonMapper MAPPER = JsonMapper.builder(JsonFactory.builder()
                    .disable(TokenStreamFactory.Feature.CANONICALIZE_PROPERTY_NAMES)
                    .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
                    .streamReadConstraints(StreamReadConstraints.builder()
                            .maxNestingDepth(DEEPEST)
                            .maxTokenCount(MOST_TOKENS)
                            .maxNameLength(LONGEST_NAME)
                            .maxNumberLength(LONGEST_NUMBER)
                            .maxStringLength(LONGEST_BYTES)
                            .maxDocumentLength(LONGEST_BYTES)
                            .build())
                    .build())
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    /** Takes all of the buffer. */
    public PacketReadResult read(ByteBuffer bytes) {
        if (bytes.remaining() > LONGEST_BYTES) {
            bytes.position(bytes.limit());
            return new PacketReadResult.Bad(Fault.TOO_LONG);
        }
        byte[] document = new byte[bytes.remaining()];
        bytes.get(document);
        // Names may come in any encoding: what is no UTF-8 is replaced and does no harm.
        JsonNode tree = tree(new String(document, StandardCharsets.UTF_8));
        return tree == null ? new PacketReadResult.Bad(Fault.NO_JSON) : read(new JsonFields(tree));
    }

    private static @Nullable JsonNode tree(String document) {
        try {
            JsonNode tree = MAPPER.readTree(document);
            return tree != null && tree.isObject() ? tree : null;
        } catch (JacksonException e) {
            // Bad input is an ordinary answer here: the session counts and reports it.
            return null;
        }
    }

    private static PacketReadResult read(JsonFields top) {
        JsonFields nested = top.inner("header");
        RoslinkHeader header = header(
                nested == null ? top : nested, nested == null ? PacketLayout.PAYLOAD : PacketLayout.NESTED_HEADER);
        if (header == null) {
            return new PacketReadResult.Bad(Fault.NO_HEADER);
        }
        JsonFields payload = top.inner("payload");
        JsonFields body = payload == null ? top : payload;
        RobotMessage message = RobotMessageReader.read(header.messageId(), body);
        if (message == null) {
            return new PacketReadResult.Bad(Fault.WITHOUT_DATA);
        }
        return new PacketReadResult.Good(new RoslinkPacket(withOwner(header, body), message));
    }

    private static @Nullable RoslinkHeader header(JsonFields fields, PacketLayout shape) {
        Integer systemId = fields.count("system_id", LARGEST_SYSTEM_ID);
        Integer messageId = fields.count("message_id", LARGEST_MESSAGE_ID);
        if (systemId == null || messageId == null) {
            return null;
        }
        return new RoslinkHeader(
                shape,
                systemId,
                messageId,
                fields.whole("sequence_number"),
                fields.word("key"),
                fields.word("owner_id"),
                Objects.requireNonNullElse(fields.count("roslink_version", 255), 1),
                Objects.requireNonNullElse(fields.count("ros_version", 255), 0));
    }

    /** The papers' robots say in a message's body whose they are, and some bridges the key too. */
    private static RoslinkHeader withOwner(RoslinkHeader header, JsonFields body) {
        StringOrNumber owner = header.owner() == null ? body.word("owner_id") : header.owner();
        StringOrNumber key = header.key() == null ? body.word("key") : header.key();
        return new RoslinkHeader(
                header.shape(),
                header.systemId(),
                header.messageId(),
                header.sequence(),
                key,
                owner,
                header.version(),
                header.rosVersion());
    }
}
