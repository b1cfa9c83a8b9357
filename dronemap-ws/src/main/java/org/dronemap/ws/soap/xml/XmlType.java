package org.dronemap.ws.soap.xml;

import java.util.List;

/** The type of a value in SOAP, both as XML and as JSON. */
public sealed interface XmlType {

    /**
     * A text.
     *
     * @param xsd of XML Schema
     * @param values all that it may be; empty: what {@code xsd} allows
     */
    record Text(String xsd, List<String> values) implements XmlType {
        public static Text of(String xsd) {
            return new Text(xsd, List.of());
        }
    }

    /** Elements called {@code item} within the one of the list, so that an empty list is not the same as none. */
    record Listed(XmlType item) implements XmlType {}

    /** Elements called {@code entry} with an attribute {@code key}. */
    record Mapped(XmlType value) implements XmlType {}

    /** A text, a number or a truth value, as its attribute {@code type} says: {@code string}, {@code number}, {@code boolean}. */
    record Plain() implements XmlType {}

    /** Reference by name to a type in {@link XmlTypes}. */
    record Named(String name) implements XmlType {}
}
