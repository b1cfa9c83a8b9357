package org.dronemap.ws.soap;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.ValueProblem;
import org.dronemap.ws.soap.SoapOperation.Argument;
import org.dronemap.ws.soap.SoapOperation.Body;
import org.dronemap.ws.soap.SoapOperation.Place;
import org.springframework.web.util.UriUtils;
import org.w3c.dom.Element;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Makes a request of REST from the element of a call. Elements may come in any order. Values that are not of their type go on as
 * texts, and members that nobody knows go on as they are, so that REST says what is wrong with them.
 */
final class CallReader {
    /** Parameter of the operations that wait for the outcome of a command: who calls by SOAP hears it in the answer. */
    private static final String WAIT = "wait";

    private static final String SECONDS_TO_WAIT = "30";

    private final XmlToJson json;
    private final JsonMapper mapper;

    CallReader(XmlTypes types, JsonMapper mapper) {
        this.json = new XmlToJson(types, mapper);
        this.mapper = mapper;
    }

    RestRequest read(SoapOperation operation, Element call) {
        Map<String, String> path = new LinkedHashMap<>();
        Map<String, String> query = new LinkedHashMap<>();
        List<Element> rest = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        for (Element child : XmlToJson.children(call)) {
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
            } else if (!XmlToJson.isNil(child)) {
                (argument.place() == Place.PATH ? path : query).put(argument.inRest(), XmlToJson.text(name, child));
            }
        }
        for (Argument argument : operation.arguments()) {
            if (argument.inRest().equals(WAIT)) {
                query.putIfAbsent(WAIT, SECONDS_TO_WAIT);
            }
        }
        String uri = uri(operation, path);
        return body(new RestRequest(operation.of().method(), uri, query), operation, rest);
    }

    private static String uri(SoapOperation operation, Map<String, String> path) {
        String uri = operation.of().path();
        for (Argument argument : operation.arguments()) {
            if (argument.place() == Place.PATH) {
                String value = path.get(argument.inRest());
                String name = argument.member().name();
                if (value == null || value.isBlank()) {
                    throw InvalidInput.missing(name, "a text");
                }
                uri = uri.replace("{" + argument.inRest() + "}", part(name, value.strip()));
            }
        }
        return uri;
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
            rest.forEach(element -> json.put(object, members.type(), "", element));
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
        String allowed = operation.elements().isEmpty()
                ? "none"
                : operation.elements().stream().map(XmlMember::name).collect(Collectors.joining(", "));
        return new InvalidInput(
                ValueProblem.MEMBER_UNKNOWN,
                name,
                allowed,
                "There is no element \"" + name + "\" here; there are: " + allowed + ".");
    }
}
