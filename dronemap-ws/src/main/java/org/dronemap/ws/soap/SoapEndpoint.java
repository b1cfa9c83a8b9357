package org.dronemap.ws.soap;

import java.util.List;
import java.util.Map;
import org.apache.cxf.Bus;
import org.apache.cxf.jaxb.JAXBDataBinding;
import org.apache.cxf.jaxws.EndpointImpl;

/** Publishes services on a bus, with bounds on the XML that they read. */
public final class SoapEndpoint {
    static final String PATH = "/MAVLinkControllerService";
    static final String FOLLOWER = "/FollowerService";

    private SoapEndpoint() {}

    public static EndpointImpl publish(Bus bus, ControllerService service) {
        return publish(bus, service, PATH);
    }

    public static EndpointImpl publish(Bus bus, FollowerService service) {
        return publish(bus, service, FOLLOWER);
    }

    private static EndpointImpl publish(Bus bus, Object service, String path) {
        // the library itself sets no bound on elements and characters
        bus.setProperty("org.apache.cxf.stax.maxElementCount", 20_000L);
        bus.setProperty("org.apache.cxf.stax.maxChildElements", 5_000);
        bus.setProperty("org.apache.cxf.stax.maxElementDepth", 30);
        bus.setProperty("org.apache.cxf.stax.maxAttributeSize", 4_096);
        bus.setProperty("org.apache.cxf.stax.maxTextLength", 65_536L);
        bus.setProperty("org.apache.cxf.stax.maxXMLCharacters", 1_048_576L);
        EndpointImpl endpoint = new EndpointImpl(bus, service);
        endpoint.setProperties(Map.of(
                "exceptionMessageCauseEnabled",
                "false",
                "faultStackTraceEnabled",
                "false",
                JAXBDataBinding.READER_VALIDATION_EVENT_HANDLER,
                new UnreadableValues()));
        endpoint.getInInterceptors()
                .addAll(List.of(
                        new RefusedBodies(),
                        new NoDoctype(),
                        new ReadingXml(),
                        new StrictElements(),
                        new NamedCalls(),
                        new RequiredElements()));
        endpoint.getOutFaultInterceptors().add(new FaultWords());
        endpoint.publish(path);
        return endpoint;
    }
}
