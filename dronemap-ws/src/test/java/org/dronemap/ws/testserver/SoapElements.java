package org.dronemap.ws.testserver;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.w3c.dom.Element;
import tools.jackson.databind.JsonNode;

/** Writes JSON as the elements that a schema of XML declares. */
final class SoapElements {
    /** The types that have names. */
    private final Map<String, Element> types;

    SoapElements(Element wsdl) {
        types = SoapOperations.within(wsdl, SoapOperations.SCHEMA, "complexType").stream()
                .filter(type -> type.hasAttribute("name"))
                .collect(Collectors.toMap(type -> type.getAttribute("name"), type -> type));
    }

    /** The members of an object as the children of an element; what the schema does not have is left out. */
    String members(Element declaration, JsonNode object) {
        StringBuilder all = new StringBuilder();
        for (Element member : declared(declaration)) {
            String name = member.getAttribute("name");
            if (object.has(name)) {
                all.append(element(member, object.path(name)));
            }
        }
        return all.toString();
    }

    private String element(Element declaration, JsonNode value) {
        String name = declaration.getAttribute("name");
        return value.isNull()
                ? SoapClient.element(name, SoapClient.NIL)
                : "<" + name + ">" + content(declaration, value) + "</" + name + ">";
    }

    private String content(Element declaration, JsonNode value) {
        List<Element> declared = declared(declaration);
        if (declared.isEmpty()) {
            return SoapClient.content(value.isContainer() ? value.toString() : value.asString());
        }
        Element first = declared.get(0);
        if (value.isArray()) {
            return value.valueStream().map(item -> element(first, item)).collect(Collectors.joining());
        }
        if (first.getAttribute("name").equals("entry")) {
            return value.properties().stream()
                    .map(entry ->
                            "<entry key=\"" + entry.getKey() + "\">" + content(first, entry.getValue()) + "</entry>")
                    .collect(Collectors.joining());
        }
        if (isChoice(declaration)) {
            Element kind = declared.stream()
                    .filter(one ->
                            one.getAttribute("name").equals(value.path("type").asString()))
                    .findFirst()
                    .orElseThrow();
            return element(kind, value);
        }
        return members(declaration, value);
    }

    private boolean isChoice(Element declaration) {
        Element type = types.get(declaration.getAttribute("type").replaceFirst(".*:", ""));
        return type != null
                && SoapOperations.children(type).stream()
                        .anyMatch(one -> one.getLocalName().equals("choice"));
    }

    /** The elements in an element; none for a text. */
    private List<Element> declared(Element declaration) {
        Element type = types.get(declaration.getAttribute("type").replaceFirst(".*:", ""));
        Element of = type != null
                ? type
                : SoapOperations.children(declaration).stream()
                        .filter(one -> one.getLocalName().equals("complexType"))
                        .findFirst()
                        .orElse(null);
        return of == null
                ? List.of()
                : SoapOperations.children(of).stream()
                        .filter(one -> one.getLocalName().matches("sequence|choice"))
                        .flatMap(group -> SoapOperations.children(group).stream())
                        .toList();
    }
}
