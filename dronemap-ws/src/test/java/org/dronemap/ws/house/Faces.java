package org.dronemap.ws.house;

import java.net.http.HttpRequest;
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

/** What a running house exposes, and a way to try each operation of it on things of somebody's choice. */
public final class Faces {
    private static final Pattern OWN = Pattern.compile("/api/v1/.*|/metrics");
    private static final Pattern VARIABLE = Pattern.compile("\\{(\\w+)}");
    private static final Pattern WSDL_OPERATION = Pattern.compile("<wsdl:operation name=\"(\\w+)\">");
    private static final List<String> SOAP = List.of("/services/MAVLinkControllerService", "/services/FollowerService");
    private static final Pattern OF_FOLLOWING =
            Pattern.compile("followRequest|sendNewGPSLocation|getFollow(sList)?|\\w+(Tracking|FollowRequest)");

    private static final Map<String, String> BODIES = Map.of(
            "PUT /api/v1/users/{name}/only-granted", "{\"onlyGranted\":false}",
            "PUT /api/v1/groups/{id}/only-granted", "{\"onlyGranted\":false}",
            "PATCH /api/v1/users/{name}", "{\"role\":\"viewer\"}",
            "POST /api/v1/drones/{id}/commands", "{\"type\":\"readParameters\"}",
            "POST /api/v1/drones/{id}/control/take-over", "{\"reason\":\"a trial\"}",
            "PUT /api/v1/drones/{id}/link-security", "{\"policy\":\"off\"}");

    private final JsonNode description;
    private final Set<String> rest;
    private final Set<String> soap;

    public Faces(TestHouse house) {
        description = new Http(house, "").get("/api/openapi.json").json();
        rest = Collections.unmodifiableSet(dispatched(house));
        soap = Collections.unmodifiableSet(described(house));
    }

    /** All that the web framework dispatches, also what the description leaves out; by method and path. */
    public Set<String> rest() {
        return rest;
    }

    private static Set<String> dispatched(TestHouse house) {
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

    /** As the WSDL says. */
    public Set<String> soap() {
        return soap;
    }

    private static Set<String> described(TestHouse house) {
        Set<String> operations = new TreeSet<>();
        for (String service : SOAP) {
            String wsdl = new Http(house, "").get(service + "?wsdl").raw().body();
            Matcher found = WSDL_OPERATION.matcher(wsdl);
            while (found.find()) {
                operations.add(found.group(1));
            }
        }
        return operations;
    }

    /** Where an operation of SOAP is served. */
    public static String serviceOf(String operation) {
        return SOAP.get(OF_FOLLOWING.matcher(operation).matches() ? 1 : 0);
    }

    /** With the values in the address, and a body that says what it takes to reach what it is about. */
    public Http.Answer rest(Http caller, String operation, Map<String, String> values) {
        String method = operation.substring(0, operation.indexOf(' '));
        String path = operation.substring(operation.indexOf(' ') + 1);
        String address = VARIABLE.matcher(path)
                .replaceAll(found ->
                        values.getOrDefault(found.group(1), found.group(1).equals("number") ? "1" : "nosuchthing"));
        return caller.send(
                address,
                request -> request.header("Content-Type", contentType(method, path))
                        .method(
                                method,
                                HttpRequest.BodyPublishers.ofString(
                                        method.equals("GET") ? "" : BODIES.getOrDefault(operation, "{}"))));
    }

    /** The element that names what an operation of SOAP is about. */
    public static String elementOf(String operation) {
        return switch (operation) {
            case "getCommand" -> "commandId";
            case "getPlan", "acceptPlan", "stopPlan", "cancelPlan", "startRun" -> "planId";
            case "getRun", "addRunWaypoint", "resumeRunDrone", "answerRun", "pauseRun", "continueRun", "stopRun" ->
                "runId";
            case "getFlight" -> "flightId";
            case "cancelFollowRequest",
                    "startTracking",
                    "sendNewGPSLocation",
                    "disableTracking",
                    "enableTracking",
                    "stopTracking",
                    "getFollow" -> "followId";
            case "issueRobotKey", "revokeRobotKey" -> "robotKeyId";
            case "createVirtualDrone" -> "name";
            case "getVirtualDrone",
                    "startVirtualDrone",
                    "stopVirtualDrone",
                    "resumeVirtualDrone",
                    "removeVirtualDrone" -> "virtualDroneId";
            default -> "droneId";
        };
    }

    /** It is about nothing in particular. */
    public static boolean isList(String operation) {
        return operation.endsWith("List");
    }

    /** What kind of thing that is. */
    public static String kindOf(String operation) {
        return switch (elementOf(operation)) {
            case "commandId" -> "commands";
            case "planId" -> "plans";
            case "flightId" -> "flights";
            case "runId" -> "runs";
            case "followId" -> "follows";
            case "robotKeyId" -> "robot-keys";
            case "name" -> "nothing";
            // Not what an organisation has: they are their owner's alone.
            case "virtualDroneId" -> "virtual drones of one's own";
            default -> "drones";
        };
    }

    /** The whole answer; {@code values} are the elements of the call. */
    public String soap(Http caller, String operation, Map<String, String> values) {
        String elements = values.entrySet().stream()
                .map(each -> "<" + each.getKey() + ">" + each.getValue() + "</" + each.getKey() + ">")
                .collect(Collectors.joining());
        String envelope = "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\""
                + " xmlns:w=\"http://cloud.dronemap.org/wsdl\"><s:Body><w:" + operation + ">" + elements + "</w:"
                + operation + "></s:Body></s:Envelope>";
        return caller.send(
                        serviceOf(operation),
                        request -> request.header("Content-Type", "text/xml")
                                .POST(HttpRequest.BodyPublishers.ofString(envelope)))
                .raw()
                .body();
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
