package org.dronemap.example;

import jakarta.xml.ws.BindingProvider;
import jakarta.xml.ws.WebServiceException;
import jakarta.xml.ws.handler.MessageContext;
import java.net.MalformedURLException;
import java.net.URI;
import java.net.URL;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.dronemap.example.soap.DronemapFault;
import org.dronemap.example.soap.MAVLinkActionWebService;
import org.dronemap.example.soap.MAVLinkControllerService;
import org.dronemap.example.soap.model.Problem;

/** Calls by SOAP with an access key, whose failures are sentences. */
final class SoapCalls {
    /** Longer than a call that waits for the outcome of a command. */
    static final Duration LONGEST = Duration.ofSeconds(60);

    /** What goes wrong is told by exceptions. Held here, since a logger that nobody holds forgets its level. */
    private static final Logger CXF = Logger.getLogger("org.apache.cxf");

    static {
        CXF.setLevel(Level.SEVERE);
    }

    interface Call<T> {
        T send() throws DronemapFault;
    }

    private SoapCalls() {}

    /** The service at the server's own address, with calls that take so long at most. */
    static MAVLinkActionWebService service(Connection connection, Duration longest) throws FlightException {
        String address = connection.server() + "/services/MAVLinkControllerService";
        MAVLinkActionWebService service =
                orProblem(() -> new MAVLinkControllerService(url(address + "?wsdl")).getMAVLinkControllerWSImplPort());
        Map<String, Object> request = ((BindingProvider) service).getRequestContext();
        request.put(BindingProvider.ENDPOINT_ADDRESS_PROPERTY, address);
        request.put(
                MessageContext.HTTP_REQUEST_HEADERS, Map.of("Authorization", List.of("Bearer " + connection.key())));
        request.put("jakarta.xml.ws.client.connectionTimeout", "10000");
        request.put("jakarta.xml.ws.client.receiveTimeout", String.valueOf(longest.toMillis()));
        // What a newer server adds to an answer is passed over.
        request.put("set-jaxb-validation-event-handler", "false");
        return service;
    }

    private static URL url(String address) {
        try {
            return URI.create(address).toURL();
        } catch (MalformedURLException e) {
            throw new IllegalStateException("An address that has been looked at is none: " + address, e);
        }
    }

    static <T> T orProblem(Call<T> call) throws FlightException {
        try {
            return call.send();
        } catch (DronemapFault fault) {
            Problem problem = fault.getFaultInfo();
            throw FlightException.ofProblem(problem.getStatus(), problem.getDetail(), problem.getCode(), fault);
        } catch (WebServiceException e) {
            throw FlightException.ofNoAnswer(e);
        }
    }
}
