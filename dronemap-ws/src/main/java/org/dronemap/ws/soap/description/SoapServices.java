package org.dronemap.ws.soap.description;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.ws.soap.xml.XmlTypes;

/** All SOAP services with their operations and types, derived from the OpenAPI description. Immutable. */
public record SoapServices(Map<String, SoapService> services, XmlTypes types, Map<String, String> without) {

    /** The services that the paper on the Dronemap Planner names. */
    static final String CONTROLLER = "MAVLinkControllerService";

    static final String FOLLOWER = "FollowerService";

    /** The paper has the follower's methods in a component of this name, too. */
    static final Map<String, String> OTHER_NAMES = Map.of("ApplicationWS", FOLLOWER);

    /** Of what is drawn together under the tags of the description; what is not named here has a service of its own. */
    private static final Map<String, List<String>> TAGS = Map.of(
            CONTROLLER,
            List.of(
                    "Drones",
                    "Commands",
                    "Control",
                    "Missions",
                    "Parameters",
                    "Fences",
                    "Logs",
                    "Sensors",
                    "Telemetry"),
            FOLLOWER,
            List.of("Follows"),
            "DispatchService",
            List.of("Dispatches"),
            "RecoveryService",
            List.of("Recoveries"),
            "PlanningService",
            List.of("Plans", "Mission runs", "Zones"),
            "VirtualDroneService",
            List.of("Virtual drones", "Warehouse"),
            "RecordService",
            List.of("Flights", "Events", "Recordings", "Replays", "Activity"),
            "FleetService",
            List.of("Groups and fleets", "Links", "Signed links", "Robot keys", "Outlet", "Enrolment"),
            "AccountService",
            List.of("Access keys", "Users", "Grants", "Invitations", "Organisations", "Registration", "Session"),
            "ServerService",
            List.of("Server", "Stream"));

    /** With the names of its ports; those of the controller are the paper's (figure 5: an excerpt of the WSDL). */
    static SoapService named(String name, List<SoapOperation> operations) {
        if (name.equals(CONTROLLER)) {
            return new SoapService(name, "MAVLinkControllerWSImplPort", "MAVLinkActionWebService", operations);
        }
        String portType = name.replaceFirst("(Service|WS)$", "");
        return new SoapService(name, portType + "Port", portType, operations);
    }

    /** The service that has the operations under a tag. */
    static String serviceOf(String tag) {
        return TAGS.entrySet().stream()
                .filter(entry -> entry.getValue().contains(tag))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElseGet(() -> ownService(tag));
    }

    private static String ownService(String tag) {
        StringBuilder name = new StringBuilder();
        for (String word : tag.split("[^A-Za-z0-9]+", -1)) {
            name.append(word.substring(0, 1).toUpperCase(java.util.Locale.ROOT)).append(word.substring(1));
        }
        return name.append("Service").toString();
    }

    public Optional<SoapService> service(String name) {
        return Optional.ofNullable(services.get(name));
    }
}
