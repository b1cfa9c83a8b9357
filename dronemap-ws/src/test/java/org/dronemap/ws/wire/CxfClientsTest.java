package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchException;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.xml.namespace.QName;
import javax.xml.parsers.DocumentBuilderFactory;
import org.apache.cxf.Bus;
import org.apache.cxf.bus.extension.ExtensionManagerBus;
import org.apache.cxf.endpoint.Client;
import org.apache.cxf.headers.Header;
import org.apache.cxf.jaxws.endpoint.dynamic.JaxWsDynamicClientFactory;
import org.apache.cxf.message.Message;
import org.apache.cxf.service.model.BindingOperationInfo;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.SoapOperations;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.springframework.beans.BeanWrapperImpl;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** Apache CXF as somebody's client: it makes its classes from the WSDLs of the running server, and calls. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class CxfClientsTest {
    private static final String NAMESPACE = "http://cloud.dronemap.org/wsdl";
    private static final String CONTROLLER = "/services/MAVLinkControllerService";
    private static final String SECURITY =
            "http://docs.oasis-open.org/wss/2004/01/oasis-200401-wss-wssecurity-secext-1.0.xsd";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final SoapOperations operations = new SoapOperations(house);
    private final ScriptedVehicle vehicle = tenant.vehicle();
    private final Map<String, Client> clients = new TreeMap<>();
    private Bus bus;
    private String key;

    @BeforeAll
    void makeClients() {
        bus = new ExtensionManagerBus();
        key = tenant.key(Role.ADMINISTRATOR);
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        try {
            for (String service : operations.services()) {
                // It leaves the loader of the classes that it makes with the thread, where its own calls look for them.
                Thread.currentThread().setContextClassLoader(before);
                clients.put(service, client(service, ""));
            }
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
    }

    @AfterAll
    void close() {
        clients.values().forEach(Client::destroy);
        bus.shutdown(true);
    }

    /** {@code port}: the end of the name of the port that is called; empty: the first one. */
    private Client client(String service, String port) {
        JaxWsDynamicClientFactory factory = JaxWsDynamicClientFactory.newInstance(bus);
        String wsdl = "http://127.0.0.1:" + house.httpPort() + service + "?wsdl";
        return port.isEmpty()
                ? factory.createClient(wsdl)
                : factory.createClient(wsdl, null, new QName(NAMESPACE, port));
    }

    private Object call(Client client, String operation, Object... arguments) throws Exception {
        Map<String, List<String>> headers = new HashMap<>(Map.of("Authorization", List.of("Bearer " + key)));
        client.getRequestContext().put(Message.PROTOCOL_HEADERS, headers);
        return client.invoke(operation, arguments)[0];
    }

    @Test
    void readWhatEachServiceAnswersToACallWithoutArguments() {
        List<String> wrong = new ArrayList<>();
        int called = 0;
        for (String operation : operations.names()) {
            SoapOperations.Operation one = operations.get(operation);
            String rest = operations.restOf(operation);
            boolean needsNothing = one.members().stream().noneMatch(SoapOperations.OrganisationMember::required);
            if (!rest.startsWith("GET ") || !needsNothing) {
                continue;
            }
            TestHttpClient.Answer byRest = new TestHttpClient(house, key).get(rest.substring("GET ".length()));
            try {
                Client client = clients.get(one.service());
                Object answer = call(client, operation, new Object[parts(client, operation)]);
                if (byRest.status() != 200 || answer == null) {
                    wrong.add(operation + ": " + answer + ", REST says "
                            + byRest.raw().body());
                }
            } catch (Exception refused) {
                if (byRest.status() == 200 || !isSame(refused, byRest)) {
                    wrong.add(operation + ": " + refused + ", REST says "
                            + byRest.raw().body());
                }
            }
            called++;
        }
        assertThat(wrong).isEmpty();
        assertThat(called).isGreaterThan(30);
        assertThat(clients).hasSizeGreaterThan(8);
    }

    /** How many arguments CXF takes for a call. */
    private static int parts(Client client, String operation) {
        BindingOperationInfo bound =
                client.getEndpoint().getBinding().getBindingInfo().getOperation(new QName(NAMESPACE, operation));
        return bound.getUnwrappedOperation().getInput().getMessageParts().size();
    }

    @Test
    void giveCommandsAndReadTheirOutcomesInBothVersions() throws Exception {
        Client eleven = clients.get(CONTROLLER);
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        Client twelve = client(CONTROLLER, "MAVLinkControllerWSImplPort12");
        Thread.currentThread().setContextClassLoader(before);
        for (Client client : List.of(eleven, twelve)) {
            Object command = call(client, "takePicture", inOrder("takePicture", Map.of("droneId", vehicle.id())));

            assertThat(value(command, "outcome.value.result")).isEqualTo("succeeded");
        }
        assertThat(vehicle.performed()).hasSize(2).hasOnlyElementsOfType(Command.TakePicture.class);
        Object drones = call(eleven, "getDronesList", inOrder("getDronesList", Map.of("active", true)));
        assertThat(value(drones, "drones.item[0].id")).isEqualTo(vehicle.id());
        twelve.destroy();
    }

    @Test
    void areToldTheCodeAndTheFieldOfWhatIsWrong() {
        Object[] high = inOrder("takeoff", Map.of("droneId", vehicle.id(), "altitude", 9000.0));
        Exception fault = catchException(() -> call(clients.get(CONTROLLER), "takeoff", high));

        assertThat(fault).hasMessageContaining("1 to 500 m");
        assertThat(value(fault, "faultInfo.code")).isEqualTo("value-out-of-range");
        assertThat(value(fault, "faultInfo.field")).isEqualTo("altitude");
        assertThat(vehicle.performed()).noneMatch(Command.TakeOff.class::isInstance);
    }

    @Test
    void signInWithAUsernameToken() throws Exception {
        String name = tenant.unique("cxf");
        String first = "first password";
        String own = "a word of my own";
        SoapClient.withKey(house, key).call("addUser", "name", name, "role", "operator", "password", first);
        SoapClient.withHeader(house, TestHttpClient.basic(name, first))
                .call("changePassword", "current", first, "next", own);
        Client client = clients.get(CONTROLLER);
        Map<String, Object> context = client.getRequestContext();
        context.remove(Message.PROTOCOL_HEADERS);
        context.put(Header.HEADER_LIST, List.of(new Header(new QName(SECURITY, "Security"), token(name, "wrong"))));
        Object[] none = new Object[parts(client, "getDronesList")];
        Exception fault = catchException(() -> client.invoke("getDronesList", none));
        assertThat(value(fault, "faultInfo.code")).isEqualTo("credentials-wrong");
        context.put(Header.HEADER_LIST, List.of(new Header(new QName(SECURITY, "Security"), token(name, own))));
        try {
            assertThat(client.invoke("getDronesList", none)[0]).isNotNull();
        } finally {
            context.remove(Header.HEADER_LIST);
        }
    }

    private static Element token(String name, String password) throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        Document document = factory.newDocumentBuilder().newDocument();
        Element security = document.createElementNS(SECURITY, "sec:Security");
        Element token = document.createElementNS(SECURITY, "sec:UsernameToken");
        security.appendChild(token);
        for (Map.Entry<String, String> each : new TreeMap<>(Map.of("sec:Username", name, "sec:Password", password))
                .descendingMap()
                .entrySet()) {
            Element element = document.createElementNS(SECURITY, each.getKey());
            element.setTextContent(each.getValue());
            token.appendChild(element);
        }
        return security;
    }

    /** Arguments in the order of the schema; what is not among them is left out. */
    private Object[] inOrder(String operation, Map<String, Object> values) {
        Map<String, Object> left = new HashMap<>(values);
        Object[] arguments = operations.get(operation).members().stream()
                .map(member -> left.remove(member.name()))
                .toArray();
        assertThat(left).isEmpty();
        return arguments;
    }

    private static Object value(Object answer, String path) {
        return new BeanWrapperImpl(answer).getPropertyValue(path);
    }

    private static boolean isSame(Exception refused, TestHttpClient.Answer byRest) {
        BeanWrapperImpl problem = new BeanWrapperImpl(refused);
        return problem.isReadableProperty("faultInfo.code")
                && byRest.text("code").equals(problem.getPropertyValue("faultInfo.code"))
                && byRest.text("detail").equals(refused.getMessage());
    }
}
