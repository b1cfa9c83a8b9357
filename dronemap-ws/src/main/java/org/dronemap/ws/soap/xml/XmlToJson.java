package org.dronemap.ws.soap.xml;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.xml.XMLConstants;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;
import tools.jackson.databind.node.StringNode;

/** Turns XML elements of a SOAP call into JSON for REST, by their types. */
public final class XmlToJson {
    static final String ITEM = "item";
    static final String ENTRY = "entry";
    static final String KEY = "key";
    static final String TYPE = "type";

    private static final Pattern NUMBER =
            Pattern.compile("[+-]?(\\d{1,40}(\\.\\d{0,40})?|\\.\\d{1,40})([eE][+-]?\\d{1,3})?");
    private static final Pattern WHOLE = Pattern.compile("[+-]?\\d{1,40}");

    private final XmlTypes types;
    private final JsonMapper mapper;

    public XmlToJson(XmlTypes types, JsonMapper mapper) {
        this.types = types;
        this.mapper = mapper;
    }

    /** {@code within}: what the element is in, for sentences. */
    public void put(ObjectNode object, XmlTypes.Structure type, String within, Element element) {
        String name = element.getLocalName();
        String field = within.isEmpty() ? name : within + "." + name;
        if (object.has(name)) {
            throw new InvalidInput(
                    ValueProblem.VALUES_EXCLUSIVE,
                    field,
                    "one element",
                    "There must be one element \"" + field + "\", not several.");
        }
        XmlMember member = type.member(name);
        if (member == null) {
            throw unknown(field, type.members());
        }
        object.set(name, value(member.type(), field, element));
    }

    /** By the names that elements have, some of which JSON has otherwise. */
    public static InvalidInput unknown(String field, List<XmlMember> known) {
        String allowed =
                known.isEmpty() ? "none" : known.stream().map(XmlMember::name).collect(Collectors.joining(", "));
        return new InvalidInput(
                ValueProblem.MEMBER_UNKNOWN,
                field,
                allowed,
                "There is no element \"" + field + "\" here; there are: " + allowed + ".");
    }

    private JsonNode value(XmlType type, String field, Element element) {
        if (isNil(element)) {
            return mapper.nullNode();
        }
        if (type instanceof XmlType.Text text) {
            return plain(text, text(field, element));
        }
        if (type instanceof XmlType.Listed listed) {
            return list(listed, field, element);
        }
        if (type instanceof XmlType.Mapped mapped) {
            return map(mapped, field, element);
        }
        if (type instanceof XmlType.Named named) {
            return complex(named.name(), field, element);
        }
        return untold(field, element);
    }

    private JsonNode untold(String field, Element element) {
        String text = text(field, element);
        return switch (element.getAttribute(TYPE)) {
            case "number" -> NUMBER.matcher(text.strip()).matches() ? number(text.strip()) : StringNode.valueOf(text);
            case "boolean" -> truth(text.strip());
            default -> StringNode.valueOf(text);
        };
    }

    private JsonNode plain(XmlType.Text type, String text) {
        String stripped = text.strip();
        return switch (type.xsd()) {
            case "boolean" -> truth(stripped);
            case "int", "long" ->
                WHOLE.matcher(stripped).matches() || NUMBER.matcher(stripped).matches()
                        ? number(stripped)
                        : StringNode.valueOf(stripped);
            case "double" -> NUMBER.matcher(stripped).matches() ? number(stripped) : StringNode.valueOf(stripped);
            case "dateTime", "base64Binary" -> StringNode.valueOf(stripped);
            default -> StringNode.valueOf(text);
        };
    }

    private JsonNode truth(String text) {
        return switch (text) {
            case "true", "1" -> mapper.getNodeFactory().booleanNode(true);
            case "false", "0" -> mapper.getNodeFactory().booleanNode(false);
            default -> StringNode.valueOf(text);
        };
    }

    private JsonNode number(String text) {
        BigDecimal value = new BigDecimal(text);
        return WHOLE.matcher(text).matches()
                ? mapper.getNodeFactory().numberNode(value.toBigInteger())
                : mapper.getNodeFactory().numberNode(value);
    }

    private ArrayNode list(XmlType.Listed type, String field, Element element) {
        noText(field, element, "elements called " + ITEM);
        ArrayNode all = mapper.createArrayNode();
        List<Element> items = children(element);
        for (Element item : items) {
            if (!item.getLocalName().equals(ITEM)) {
                throw new InvalidInput(
                        ValueProblem.VALUE_MALFORMED,
                        field,
                        "elements called " + ITEM,
                        "\"" + field + "\" must have elements called " + ITEM + ", not " + item.getLocalName() + ".");
            }
            all.add(value(type.item(), field + "[" + all.size() + "]", item));
        }
        return all;
    }

    private ObjectNode map(XmlType.Mapped type, String field, Element element) {
        noText(field, element, "elements called " + ENTRY);
        ObjectNode all = mapper.createObjectNode();
        for (Element entry : children(element)) {
            String key = entry.getAttribute(KEY);
            if (!entry.getLocalName().equals(ENTRY) || key.isEmpty() || all.has(key)) {
                throw new InvalidInput(
                        ValueProblem.VALUE_MALFORMED,
                        field,
                        "elements called " + ENTRY,
                        "\"" + field + "\" must have elements called " + ENTRY + ", each with a " + KEY
                                + " of its own.");
            }
            all.set(key, value(type.value(), field + "." + key, entry));
        }
        return all;
    }

    private JsonNode complex(String name, String field, Element element) {
        XmlTypes.Complex type = types.get(name);
        noText(field, element, "elements");
        ObjectNode object = mapper.createObjectNode();
        if (type instanceof XmlTypes.Structure structure) {
            children(element).forEach(child -> put(object, structure, field, child));
            return object;
        }
        XmlTypes.Alternatives alternatives = (XmlTypes.Alternatives) type;
        List<Element> told = children(element);
        if (told.size() != 1) {
            String allowed = "one of " + String.join(", ", alternatives.kinds().keySet());
            throw new InvalidInput(
                    ValueProblem.VALUES_EXCLUSIVE,
                    field,
                    allowed,
                    "\"" + field + "\" must have exactly " + allowed + ".");
        }
        Element chosen = told.get(0);
        object.put(alternatives.discriminator(), chosen.getLocalName());
        String kind = alternatives.kinds().get(chosen.getLocalName());
        if (kind != null) {
            children(chosen).forEach(child -> put(object, types.structure(kind), field, child));
        }
        return object;
    }

    public static List<Element> children(Element element) {
        List<Element> all = new ArrayList<>();
        for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node instanceof Element child) {
                all.add(child);
            }
        }
        return all;
    }

    public static String text(String field, Element element) {
        List<Element> within = children(element);
        if (!within.isEmpty()) {
            throw new InvalidInput(
                    ValueProblem.VALUE_MALFORMED,
                    field,
                    "a text",
                    "\"" + field + "\" must be a text; it has elements: "
                            + within.stream().map(Element::getLocalName).collect(Collectors.joining(", ")) + ".");
        }
        return element.getTextContent();
    }

    private static void noText(String field, Element element, String wanted) {
        for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
            boolean words = node.getNodeType() == Node.TEXT_NODE || node.getNodeType() == Node.CDATA_SECTION_NODE;
            if (words && !isBlank(node.getNodeValue())) {
                throw new InvalidInput(
                        ValueProblem.VALUE_MALFORMED,
                        field,
                        wanted,
                        "\"" + field + "\" must have " + wanted + ", not a text.");
            }
        }
    }

    private static boolean isBlank(@Nullable String text) {
        return text == null || text.isBlank();
    }

    public static boolean isNil(Element element) {
        String nil = element.getAttributeNS(XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI, "nil");
        return nil.equals("true") || nil.equals("1");
    }
}
