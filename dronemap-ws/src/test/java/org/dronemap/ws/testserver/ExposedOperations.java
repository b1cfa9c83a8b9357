package org.dronemap.ws.testserver;

import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.springframework.web.servlet.mvc.method.annotation.RequestMappingHandlerMapping;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** What a running house exposes, and a way to try each operation of it on things of somebody's choice. */
public final class ExposedOperations {
    private static final Pattern OWN = Pattern.compile("/api/v1/.*|/metrics");
    private static final Pattern VARIABLE = Pattern.compile("\\{(\\w+)}");
    private static final Pattern PROBLEM = Pattern.compile("<type>urn:dronemap:problem:([a-z-]+)</type>");
    /** The element with the bytes of a file. */
    private static final String CONTENT = "content";

    private static final JsonMapper JSON = JsonMapper.shared();

    private static final Map<String, String> BODIES = Map.of(
            "PUT /api/v1/users/{name}/only-granted", "{\"onlyGranted\":false}",
            "PUT /api/v1/groups/{id}/only-granted", "{\"onlyGranted\":false}",
            "PATCH /api/v1/users/{name}", "{\"role\":\"viewer\"}",
            "PATCH /api/v1/flights/{id}", "{\"notes\":\"a trial\"}",
            "POST /api/v1/drones/{id}/commands", "{\"type\":\"readParameters\"}",
            "POST /api/v1/drones/{id}/control/take-over", "{\"reason\":\"a trial\"}",
            "PUT /api/v1/drones/{id}/link-security", "{\"policy\":\"off\"}");

    private final JsonNode description;
    private final CommandBodies commands;
    private final Set<String> rest;
    private final SoapOperations soap;

    public ExposedOperations(TestServer house) {
        description = new TestHttpClient(house, "").get("/api/openapi.json").json();
        commands = new CommandBodies(description);
        rest = Collections.unmodifiableSet(dispatched(house));
        soap = new SoapOperations(house);
    }

    /** All that the web framework dispatches, also what the description leaves out; by method and path. */
    public Set<String> rest() {
        return rest;
    }

    private static Set<String> dispatched(TestServer house) {
        Set<String> operations = new TreeSet<>();
        house.bean(RequestMappingHandlerMapping.class)
                .getHandlerMethods()
                .keySet()
                .forEach(mapping -> mapping.getPatternValues().stream()
                        .filter(path -> OWN.matcher(path).matches())
                        .forEach(path -> mapping.getMethodsCondition()
                                .getMethods()
                                .forEach(method -> operations.add(method.name() + " " + path))));
        return operations;
    }

    /** The names of all operations, as the WSDLs say. */
    public Set<String> soap() {
        return soap.names();
    }

    /** The addresses of all services of SOAP. */
    public Set<String> services() {
        return soap.services();
    }

    /** The operation of REST that one of SOAP is, by method and path. */
    public String restOf(String operation) {
        return soap.restOf(operation);
    }

    /** The names of SOAP of an operation of REST. */
    public Set<String> soapOf(String rest) {
        return soap.of(rest);
    }

    /** The elements of a call of an operation. */
    public List<SoapOperations.OrganisationMember> elements(String operation) {
        return soap.get(operation).members();
    }

    /** With the values in the address, and a body that says what it takes to reach what it is about. */
    public TestHttpClient.Answer rest(TestHttpClient caller, String operation, Map<String, String> values) {
        String method = operation.substring(0, operation.indexOf(' '));
        String path = operation.substring(operation.indexOf(' ') + 1);
        String address = VARIABLE.matcher(path).replaceAll(found -> valueOf(found.group(1), values));
        return caller.send(
                address,
                request -> request.header("Content-Type", contentType(method, path))
                        .method(
                                method,
                                HttpRequest.BodyPublishers.ofString(
                                        method.equals("GET") ? "" : BODIES.getOrDefault(operation, "{}"))));
    }

    /** The element that names what an operation of SOAP is about; empty: it is about nothing in particular. */
    public String elementOf(String operation) {
        return restOf(operation).contains("{") ? elements(operation).get(0).name() : "";
    }

    /** It is about nothing in particular. */
    public boolean isList(String operation) {
        return elementOf(operation).isEmpty();
    }

    /** The whole answer; {@code values} are the elements of the call. */
    public String soap(TestHttpClient caller, String operation, Map<String, String> values) {
        String elements = values.entrySet().stream()
                .filter(each -> !each.getKey().isEmpty())
                .map(each -> "<" + each.getKey() + ">" + each.getValue() + "</" + each.getKey() + ">")
                .collect(Collectors.joining());
        return call(caller, operation, elements).raw().body();
    }

    public CommandBodies commands() {
        return commands;
    }

    /** The type of command that an operation of SOAP gives. */
    public String commandOf(String operation) {
        return commands.types().stream()
                .filter(operation::equalsIgnoreCase)
                .findFirst()
                .orElseThrow();
    }

    /** Gives a command that lacks nothing to a drone. */
    public TestHttpClient.Answer command(TestHttpClient caller, String operation, String drone) {
        ObjectNode elements = commands.least(commandOf(operation));
        elements.put(elementOf(operation), drone);
        return call(caller, operation, soap.get(operation).written(elements));
    }

    /** {@code elements}: as they stand in the call. */
    public TestHttpClient.Answer call(TestHttpClient caller, String operation, String elements) {
        String envelope = SoapClient.envelope("", SoapClient.call(operation, elements));
        return caller.send(
                soap.get(operation).service(),
                request ->
                        request.header("Content-Type", "text/xml").POST(HttpRequest.BodyPublishers.ofString(envelope)));
    }

    /**
     * The same as {@link #rest} with the same values: those of the variables in REST's address, and the body that it takes to
     * reach what it is about.
     */
    public TestHttpClient.Answer soapAsRest(TestHttpClient caller, String operation, Map<String, String> values) {
        ObjectNode elements = JSON.createObjectNode();
        JSON.readTree(BODIES.getOrDefault(restOf(operation), "{}"))
                .properties()
                .forEach(member -> elements.set(member.getKey(), member.getValue()));
        Matcher variable = VARIABLE.matcher(restOf(operation));
        for (SoapOperations.OrganisationMember element : elements(operation)) {
            if (variable.find()) {
                elements.put(element.name(), valueOf(variable.group(1), values));
            }
        }
        if (takesFile(operation)) {
            elements.put(CONTENT, base64("{}"));
        }
        return call(caller, operation, soap.get(operation).written(elements));
    }

    /** What a deed does, through SOAP: its address, its parameters and its body are the elements of the call. */
    public TestHttpClient.Answer soap(SuccessfulCalls.PreparedCall deed, String operation) {
        String[] path = deed.path().split("\\?", 2);
        ObjectNode elements = JSON.createObjectNode();
        if (takesFile(operation)) {
            elements.put(CONTENT, base64(deed.body()));
        } else if (!deed.body().isBlank()) {
            JSON.readTree(deed.body()).properties().forEach(member -> elements.set(member.getKey(), member.getValue()));
        }
        String[] parts = path[0].split("/");
        String[] pattern = restOf(operation).replaceFirst(".* ", "").split("/");
        int variable = 0;
        for (int i = 0; i < pattern.length; i++) {
            if (pattern[i].startsWith("{")) {
                elements.put(elements(operation).get(variable++).name(), parts[i]);
            }
        }
        if (path.length > 1) {
            for (String parameter : path[1].split("&")) {
                String[] both = parameter.split("=", 2);
                elements.put(both[0], both[1]);
            }
        }
        return call(deed.who(), operation, soap.get(operation).written(elements));
    }

    private boolean takesFile(String operation) {
        return elements(operation).stream().anyMatch(element -> element.name().equals(CONTENT));
    }

    private static String base64(String text) {
        return Base64.getEncoder().encodeToString(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String valueOf(String variable, Map<String, String> values) {
        return values.getOrDefault(variable, variable.equals("number") ? "1" : "nosuchthing");
    }

    /** The word for what is wrong in a fault, such as {@code forbidden}; empty when it is none. */
    public static String wrong(String answer) {
        Matcher type = PROBLEM.matcher(answer);
        return type.find() ? type.group(1) : "";
    }

    /** Elements of a call in the order that the description wants. */
    public static Map<String, String> inOrder(String first, String value, String second, String other) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put(first, value);
        values.put(second, other);
        return values;
    }

    private String contentType(String method, String path) {
        JsonNode content = description
                .path("paths")
                .path(path)
                .path(method.toLowerCase(Locale.ROOT))
                .path("requestBody")
                .path("content");
        return content.propertyNames().stream().findFirst().orElse("application/json");
    }
}
