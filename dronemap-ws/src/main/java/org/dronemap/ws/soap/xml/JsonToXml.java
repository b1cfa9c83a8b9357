package org.dronemap.ws.soap.xml;

import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import tools.jackson.databind.JsonNode;

/** Writes JSON as elements by their types. Members without a value are left out, as their schema allows. */
public final class JsonToXml {
    static final String TYPE = "type";

    private static final int UNKNOWN = 0xFFFD;

    private final XmlTypes types;

    public JsonToXml(XmlTypes types) {
        this.types = types;
    }

    public void write(XMLStreamWriter out, String element, XmlType type, JsonNode value) throws XMLStreamException {
        out.writeStartElement(element);
        content(out, type, value);
        out.writeEndElement();
    }

    private void content(XMLStreamWriter out, XmlType type, JsonNode value) throws XMLStreamException {
        if (value.isNull()) {
            out.writeNamespace("xsi", XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI);
            out.writeAttribute("xsi", XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI, "nil", "true");
        } else if (type instanceof XmlType.Text) {
            out.writeCharacters(plain(value.asString()));
        } else if (type instanceof XmlType.Plain) {
            out.writeAttribute(TYPE, value.getNodeType().name().toLowerCase(Locale.ROOT));
            out.writeCharacters(plain(value.asString()));
        } else if (type instanceof XmlType.Listed listed) {
            for (JsonNode item : value) {
                write(out, XmlToJson.ITEM, listed.item(), item);
            }
        } else if (type instanceof XmlType.Mapped mapped) {
            for (var entry : value.properties()) {
                out.writeStartElement(XmlToJson.ENTRY);
                out.writeAttribute(XmlToJson.KEY, plain(entry.getKey()));
                content(out, mapped.value(), entry.getValue());
                out.writeEndElement();
            }
        } else if (type instanceof XmlType.Named named) {
            complex(out, types.get(named.name()), value);
        }
    }

    private void complex(XMLStreamWriter out, XmlTypes.Complex type, JsonNode value) throws XMLStreamException {
        if (type instanceof XmlTypes.Structure structure) {
            members(out, structure, value);
        } else if (type instanceof XmlTypes.Alternatives alternatives) {
            String kind = value.path(alternatives.told()).asString();
            out.writeStartElement(kind);
            members(out, types.structure(alternatives.kinds().getOrDefault(kind, "")), value);
            out.writeEndElement();
        }
    }

    public void members(XMLStreamWriter out, XmlTypes.Structure type, JsonNode value) throws XMLStreamException {
        for (XmlMember member : type.members()) {
            JsonNode of = value.path(member.name());
            if (!of.isMissingNode() && !of.isNull()) {
                write(out, member.name(), member.type(), of);
            }
        }
    }

    /** What XML 1.0 cannot carry becomes the sign for that. */
    static String plain(String text) {
        return isPlain(text)
                ? text
                : text.codePoints()
                        .map(letter -> isCarried(letter) ? letter : UNKNOWN)
                        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                        .toString();
    }

    /** Nearly all texts are: this is looked at first, and quickly. */
    private static boolean isPlain(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (Character.isSurrogate(text.charAt(i)) || !isCarried(text.charAt(i))) {
                return text.codePoints().allMatch(JsonToXml::isCarried);
            }
        }
        return true;
    }

    private static boolean isCarried(int letter) {
        return (letter >= ' ' && letter < Character.MIN_SURROGATE)
                || (letter > Character.MAX_SURROGATE && letter != 0xFFFE && letter != 0xFFFF)
                || letter == '\t'
                || letter == '\n'
                || letter == '\r';
    }
}
