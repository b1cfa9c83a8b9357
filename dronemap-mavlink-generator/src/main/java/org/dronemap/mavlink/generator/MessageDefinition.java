package org.dronemap.mavlink.generator;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The definition of one MAVLink message.
 *
 * @param id its number, from 0
 * @param name as MAVLink writes it, in capitals with underscores
 * @param fields in the order in which they are defined
 */
public record MessageDefinition(int id, String name, List<MessageField> fields) {
    private static final int CRC_START = 0xFFFF;

    /** A field and the octet of the payload that it begins at. */
    public record Place(MessageField field, int offset) {}

    public MessageDefinition {
        fields = List.copyOf(fields);
    }

    /** As Java writes it. */
    public String recordName() {
        return JavaNames.ofType(name);
    }

    /** The largest first, those of the same size as defined; extensions as defined, after all others. */
    public List<Place> wireOrder() {
        List<MessageField> ordered = fields.stream()
                .sorted(Comparator.comparing(MessageField::extension)
                        .thenComparing(
                                field -> field.extension() ? 0 : -field.type().size()))
                .toList();
        List<Place> places = new ArrayList<>();
        int offset = 0;
        for (MessageField field : ordered) {
            places.add(new Place(field, offset));
            offset += field.length();
        }
        return places;
    }

    /** Octets of the payload with all extensions. */
    public int longestPayload() {
        return fields.stream().mapToInt(MessageField::length).sum();
    }

    /** Octets of the payload that MAVLink 1 knows. */
    public int shortestPayload() {
        return fields.stream()
                .filter(field -> !field.extension())
                .mapToInt(MessageField::length)
                .sum();
    }

    /** Of all that MAVLink 1 knows, so that who defines a message otherwise takes its frames for damaged (CRC_EXTRA). */
    public int checksumSeed() {
        int crc = added(CRC_START, name);
        for (Place place : wireOrder()) {
            MessageField field = place.field();
            if (!field.extension()) {
                crc = added(added(crc, field.type().definedAs()), field.name());
                crc = field.elements() > 0 ? added(crc, (byte) field.elements()) : crc;
            }
        }
        return (crc & 0xFF) ^ (crc >> 8);
    }

    private static int added(int crc, String word) {
        int sum = crc;
        for (byte octet : (word + " ").getBytes(StandardCharsets.US_ASCII)) {
            sum = added(sum, octet);
        }
        return sum;
    }

    /** CRC-16/MCRF4XX, as MAVLink's frames have it. */
    private static int added(int crc, byte octet) {
        int low = (octet ^ crc) & 0xFF;
        low = (low ^ (low << 4)) & 0xFF;
        return (crc >> 8) ^ ((low << 8) & 0xFFFF) ^ (low << 3) ^ (low >> 4);
    }
}
