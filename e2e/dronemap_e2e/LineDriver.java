import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.xml.ws.BindingProvider;
import jakarta.xml.ws.handler.MessageContext;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dronemap.example.rest.ApiClient;
import org.dronemap.example.rest.ApiException;
import org.dronemap.example.rest.CommandsApi;
import org.dronemap.example.rest.ControlApi;
import org.dronemap.example.rest.DronesApi;
import org.dronemap.example.rest.model.CommandRequest;
import org.dronemap.example.rest.model.Problem;
import org.dronemap.example.soap.DronemapFault;
import org.dronemap.example.soap.MAVLinkActionWebService;
import org.dronemap.example.soap.MAVLinkControllerService;
import org.dronemap.example.soap.model.CommandView;
import org.dronemap.example.soap.model.DroneView;
import org.dronemap.example.soap.model.ListOfMissionItemRequest;
import org.dronemap.example.soap.model.MissionItemRequest;
import org.dronemap.example.soap.model.WaypointItem;

/**
 * Carries out what lines of JSON on the standard input ask for, and answers each with a line, by the classes that the
 * Java example generates: of REST or of SOAP, as the argument says. The lines are those of
 * sdk-typescript/dev/line-driver.ts.
 */
public final class LineDriver {
    private static final double OUTCOME_SECONDS = 60;
    // Unlike in requests, what is null is told.
    private static final ObjectMapper JSON = ApiClient.createDefaultObjectMapper()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .setSerializationInclusion(JsonInclude.Include.ALWAYS);
    private static final String SERVER = System.getenv("DRONEMAP_URL");
    private static final String AUTHORIZATION = "Bearer " + System.getenv("DRONEMAP_KEY");

    private interface Face {
        List<String> drones() throws Exception;

        Object control(String operation, String drone) throws Exception;

        Object command(String drone, ObjectNode body) throws Exception;

        /** The members of a problem; throws what is none. */
        Map<String, Object> problem(Exception failed) throws Exception;
    }

    public static void main(String[] arguments) throws Exception {
        Face face = arguments[0].equals("rest") ? new Rest() : new Soap();
        BufferedReader lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            System.out.println(JSON.writeValueAsString(answer(face, JSON.readTree(line))));
        }
        System.exit(0);
    }

    private static Object answer(Face face, JsonNode asked) throws Exception {
        try {
            return switch (asked.get("do").asText()) {
                case "list" -> face.drones();
                case "rest" ->
                    face.control(
                            asked.get("operation").asText(),
                            asked.get("parameters").get("id").asText());
                case "command" -> {
                    ObjectNode body = (ObjectNode) asked.get("body");
                    body.put("id", UUID.randomUUID().toString());
                    yield face.command(asked.get("drone").asText(), body);
                }
                default -> throw new IllegalArgumentException("Not a request: " + asked);
            };
        } catch (ApiException | DronemapFault failed) {
            return face.problem(failed);
        }
    }

    private static final class Rest implements Face {
        private final ApiClient client = new ApiClient();

        Rest() {
            client.updateBaseUri(SERVER);
            client.setRequestInterceptor(request -> request.header("Authorization", AUTHORIZATION));
        }

        @Override
        public List<String> drones() throws ApiException {
            return new DronesApi(client)
                    .listDrones(null).getDrones().stream()
                            .map(drone -> drone.getId())
                            .toList();
        }

        @Override
        public Object control(String operation, String drone) throws ApiException {
            ControlApi control = new ControlApi(client);
            return operation.equals("takeControl") ? control.takeControl(drone) : control.releaseControl(drone);
        }

        @Override
        public Object command(String drone, ObjectNode body) throws ApiException, IOException {
            CommandRequest command = JSON.treeToValue(body, CommandRequest.class);
            return new CommandsApi(client)
                    .giveCommand(drone, command, OUTCOME_SECONDS)
                    .getOutcome();
        }

        @Override
        public Map<String, Object> problem(Exception failed) throws Exception {
            String body = ((ApiException) failed).getResponseBody();
            if (body == null) {
                throw failed;
            }
            Problem problem = JSON.readValue(body, Problem.class);
            Map<String, Object> members = new LinkedHashMap<>();
            members.put("status", problem.getStatus());
            members.put("code", problem.getCode());
            members.put("detail", problem.getDetail());
            members.put("field", problem.getField());
            members.put("commandId", problem.getCommandId());
            return members;
        }
    }

    private static final class Soap implements Face {
        private final MAVLinkActionWebService service;

        Soap() throws IOException {
            String address = SERVER + "/services/MAVLinkControllerService";
            service = new MAVLinkControllerService(URI.create(address + "?wsdl").toURL())
                    .getMAVLinkControllerWSImplPort();
            ((BindingProvider) service)
                    .getRequestContext()
                    .put(MessageContext.HTTP_REQUEST_HEADERS, Map.of("Authorization", List.of(AUTHORIZATION)));
        }

        @Override
        public List<String> drones() throws DronemapFault {
            return service.getDronesList(null).getDrones().getItem().stream()
                    .map(DroneView::getId)
                    .toList();
        }

        @Override
        public Object control(String operation, String drone) throws DronemapFault {
            return operation.equals("takeControl") ? service.takeControl(drone) : service.releaseControl(drone);
        }

        @Override
        public Object command(String drone, ObjectNode body) throws DronemapFault {
            return given(drone, body).getOutcome();
        }

        private CommandView given(String drone, ObjectNode body) throws DronemapFault {
            String id = body.get("id").asText();
            return switch (body.get("type").asText()) {
                case "arm" -> service.arm(drone, id, null, OUTCOME_SECONDS);
                case "takeOff" -> service.takeoff(drone, number(body, "altitude"), id, null, OUTCOME_SECONDS);
                case "goTo" ->
                    service.gotoPlace(
                            drone,
                            number(body, "latitude"),
                            number(body, "longitude"),
                            number(body, "altitude"),
                            null,
                            id,
                            null,
                            OUTCOME_SECONDS);
                case "uploadMission" -> service.uploadMission(drone, items(body), id, null, OUTCOME_SECONDS);
                case "startMission" -> service.startMission(drone, null, id, null, OUTCOME_SECONDS);
                case "returnToLaunch" -> service.returnToLaunch(drone, id, null, OUTCOME_SECONDS);
                default -> throw new IllegalArgumentException("No command of the flight: " + body);
            };
        }

        private static double number(ObjectNode body, String member) {
            return body.get(member).asDouble();
        }

        private static ListOfMissionItemRequest items(ObjectNode body) {
            ListOfMissionItemRequest items = new ListOfMissionItemRequest();
            for (JsonNode step : body.get("items")) {
                MissionItemRequest item = new MissionItemRequest();
                item.setWaypoint(JSON.convertValue(step, WaypointItem.class));
                items.getItem().add(item);
            }
            return items;
        }

        @Override
        public Map<String, Object> problem(Exception failed) {
            var problem = ((DronemapFault) failed).getFaultInfo();
            Map<String, Object> members = new LinkedHashMap<>();
            members.put("status", problem.getStatus());
            members.put("code", problem.getCode());
            members.put("detail", problem.getDetail());
            members.put("field", problem.getField());
            members.put("commandId", problem.getCommandId());
            return members;
        }
    }
}
