package org.dronemap.mavlink.generator;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/** A type of MAVLink message fields: its size on the wire, its Java type and accessor in generated code. */
public enum FieldType {
    CHAR("char", 1, "String", "text"),
    INT8("int8_t", 1, "int", "i8"),
    UINT8("uint8_t", 1, "int", "u8"),
    INT16("int16_t", 2, "int", "i16"),
    UINT16("uint16_t", 2, "int", "u16"),
    INT32("int32_t", 4, "int", "i32"),
    /** Wider in Java, which has no unsigned numbers. */
    UINT32("uint32_t", 4, "long", "u32"),
    INT64("int64_t", 8, "long", "i64"),
    /** As signed: Java has nothing wider. */
    UINT64("uint64_t", 8, "long", "i64"),
    FLOAT("float", 4, "float", "f32"),
    DOUBLE("double", 8, "double", "f64");

    private final String definedAs;
    private final int size;
    private final String javaType;
    private final String accessor;

    FieldType(String definedAs, int size, String javaType, String accessor) {
        this.definedAs = definedAs;
        this.size = size;
        this.javaType = javaType;
        this.accessor = accessor;
    }

    /** Empty for a name that MAVLink has no type for. */
    static Optional<FieldType> find(String definedAs) {
        return Arrays.stream(values())
                .filter(type -> type.definedAs.equals(definedAs))
                .findFirst();
    }

    /** As MAVLink's definitions call it, which is part of a message's checksum seed. */
    public String definedAs() {
        return definedAs;
    }

    /** Octets of one element on the wire. */
    public int size() {
        return size;
    }

    String javaType() {
        return javaType;
    }

    /** What Frame and PayloadWriter call the method for one element. */
    String accessor() {
        return accessor;
    }

    /** The names of all, for who has given another one. */
    static String known() {
        return Arrays.stream(values()).map(FieldType::definedAs).collect(Collectors.joining(", "));
    }
}
