package org.dronemap.ws.soap;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.soap.description.SoapOperation;
import org.dronemap.ws.soap.description.SoapOperation.Argument;
import org.dronemap.ws.soap.description.SoapOperation.Body;
import org.dronemap.ws.soap.description.SoapOperation.Place;
import org.dronemap.ws.soap.xml.XmlToJson;
import org.dronemap.ws.soap.xml.XmlTypes;
import org.springframework.web.util.UriUtils;
import org.w3c.dom.Element;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Turns the XML element of a SOAP call into the REST request that carries it out. Elements may come in any order.
 * Values that are not of their type go on as texts, and members that nobody knows go on as they are, so that REST says
 * what is wrong with them.
 */
final class SoapRequestReader {
    /** Parameter of the operations that wait for an outcome or an event: who calls by SOAP hears it in the answer. */
    private static final String WAIT = "wait";

    private static final String SECONDS_TO_WAIT = "30";

    /** In an address that is refused for it. */
    private static final String NOT_SAID = "-";

    private final XmlToJson json;
    private final JsonMapper mapper;

    SoapRequestReader(XmlTypes types, JsonMapper mapper) {
        this.json = new XmlToJson(types, mapper);
        this.mapper = mapper;
    }

    /** What is wrong with a call is told by the request, once it is known that its caller may make it. */
    RestRequest read(SoapOperation operation, Element call) {
        Map<String, String> path = new LinkedHashMap<>();
        try {
            return asked(operation, call, path);
        } catch (Rejection wrong) {
            return new RestRequest(operation.of().method(), uri(operation, path), Map.of()).refused(wrong);
        }
    }

    /** {@code path}: takes what the call says for the address, encoded. */
    private RestRequest asked(SoapOperation operation, Element call, Map<String, String> path) {
        List<Element> children = XmlToJson.children(call);
        for (Argument argument : operation.arguments()) {
            if (argument.place() == Place.PATH) {
                path.put(argument.inRest(), part(argument.member().name(), children));
            }
        }
        Map<String, String> query = new LinkedHashMap<>();
        List<Element> rest = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        for (Element child : children) {
            String name = child.getLocalName();
            if (!seen.add(name)) {
                throw new InvalidInput(
                        ValueProblem.VALUES_EXCLUSIVE,
                        name,
                        "one element",
                        "There must be one element \"" + name + "\", not several.");
            }
            Argument argument = operation.argument(name).orElse(null);
            if (argument == null) {
                rest.add(child);
            } else if (argument.place() == Place.QUERY && !XmlToJson.isNil(child)) {
                query.put(argument.inRest(), XmlToJson.text(name, child));
            }
        }
        for (Argument argument : operation.arguments()) {
            if (argument.inRest().equals(WAIT)) {
                query.putIfAbsent(WAIT, SECONDS_TO_WAIT);
            }
        }
        return body(new RestRequest(operation.of().method(), uri(operation, path), query), operation, rest);
    }

    private static String uri(SoapOperation operation, Map<String, String> path) {
        String uri = operation.of().path();
        for (Argument argument : operation.arguments()) {
            if (argument.place() == Place.PATH) {
                uri = uri.replace("{" + argument.inRest() + "}", path.getOrDefault(argument.inRest(), NOT_SAID));
            }
        }
        return uri;
    }

    private static String part(String name, List<Element> children) {
        String value = children.stream()
                .filter(child -> child.getLocalName().equals(name) && !XmlToJson.isNil(child))
                .findFirst()
                .map(child -> XmlToJson.text(name, child))
                .orElse("");
        if (value.isBlank()) {
            throw InvalidInput.missing(name, "a text");
        }
        return part(name, value.strip());
    }

    /** What no address can have is not the name of anything. */
    private static String part(String name, String value) {
        boolean never = value.equals(".")
                || value.equals("..")
                || value.chars().anyMatch(letter -> letter < ' ' || letter == 0x7f || "/\\;".indexOf(letter) >= 0);
        if (never) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED,
                    name,
                    "a text without '/', '\\', ';' and control characters",
                    "\"" + value + "\"");
        }
        return UriUtils.encodePathSegment(value, StandardCharsets.UTF_8);
    }

    private RestRequest body(RestRequest request, SoapOperation operation, List<Element> rest) {
        if (operation.body() instanceof Body.Members members) {
            ObjectNode object = mapper.createObjectNode();
            if (members.fixed() != null) {
                object.put(members.fixed().member(), members.fixed().value());
            }
            for (Element element : rest) {
                if (members.type().member(element.getLocalName()) == null) {
                    throw unknown(operation, element.getLocalName());
                }
                json.put(object, members.type(), "", element);
            }
            boolean none = rest.isEmpty() && !members.required();
            return none ? request : request.with("application/json", mapper.writeValueAsBytes(object));
        }
        if (operation.body() instanceof Body.File file) {
            return request.with(file.mediaType(), content(operation, rest));
        }
        if (!rest.isEmpty()) {
            throw unknown(operation, rest.get(0).getLocalName());
        }
        return request;
    }

    private static byte[] content(SoapOperation operation, List<Element> rest) {
        Element found = null;
        for (Element element : rest) {
            if (!element.getLocalName().equals(SoapOperation.CONTENT)) {
                throw unknown(operation, element.getLocalName());
            }
            found = element;
        }
        if (found == null) {
            throw InvalidInput.missing(SoapOperation.CONTENT, "the file as base64");
        }
        try {
            return Base64.getMimeDecoder().decode(XmlToJson.text(SoapOperation.CONTENT, found));
        } catch (IllegalArgumentException notBase64) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, SoapOperation.CONTENT, "base64", "something else");
        }
    }

    private static InvalidInput unknown(SoapOperation operation, String name) {
        return XmlToJson.unknown(name, operation.elements());
    }
}
