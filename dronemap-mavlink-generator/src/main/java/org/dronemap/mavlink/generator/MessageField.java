package org.dronemap.mavlink.generator;

/**
 * A field of a MAVLink message, as the definition file describes it.
 *
 * @param name as MAVLink writes it, in lower case with underscores
 * @param elements of an array or text; 0: one value alone
 * @param extension whether MAVLink 1 does not know it
 */
public record MessageField(FieldType type, int elements, String name, boolean extension) {
    /** Octets on the wire. */
    public int length() {
        return type.size() * Math.max(1, elements);
    }

    /** Texts are one value in Java. */
    boolean isArray() {
        return elements > 0 && type != FieldType.CHAR;
    }

    String javaType() {
        return type.javaType() + (isArray() ? "[]" : "");
    }

    /** As Java writes it: the first word in lower case, each other one begins with a capital. */
    public String javaName() {
        return JavaNames.joined(name);
    }
}
