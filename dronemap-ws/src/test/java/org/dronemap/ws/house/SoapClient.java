package org.dronemap.ws.house;

import jakarta.xml.ws.BindingProvider;
import jakarta.xml.ws.Service;
import jakarta.xml.ws.handler.MessageContext;
import java.net.MalformedURLException;
import java.net.URI;
import java.util.List;
import java.util.Map;
import javax.xml.namespace.QName;
import org.dronemap.ws.soap.MAVLinkController;

/** A SOAP client that knows only the WSDL. */
public final class SoapClient {
    private static final String NAMESPACE = "http://cloud.dronemap.org/wsdl";

    private SoapClient() {}

    public static MAVLinkController withKey(TestHouse house, String key) {
        return withHeader(house, "Bearer " + key);
    }

    public static MAVLinkController withHeader(TestHouse house, String authorization) {
        String address = "http://127.0.0.1:" + house.httpPort() + "/services/MAVLinkControllerService";
        try {
            Service service = Service.create(
                    URI.create(address + "?wsdl").toURL(), new QName(NAMESPACE, "MAVLinkControllerService"));
            MAVLinkController port =
                    service.getPort(new QName(NAMESPACE, "MAVLinkControllerWSImplPort"), MAVLinkController.class);
            ((BindingProvider) port)
                    .getRequestContext()
                    .put(MessageContext.HTTP_REQUEST_HEADERS, Map.of("Authorization", List.of(authorization)));
            return port;
        } catch (MalformedURLException e) {
            throw new IllegalStateException(e);
        }
    }
}
