package org.dronemap.ws.soap;

import jakarta.xml.ws.soap.SOAPBinding;
import java.util.List;
import java.util.Map;
import org.apache.cxf.Bus;
import org.apache.cxf.jaxws.EndpointImpl;

/** Publishes a SOAP service on the CXF bus, with limits on the XML that it reads. */
final class SoapEndpointFactory {
    private SoapEndpointFactory() {}

    /** At {@code /name}; takes SOAP 1.1 and 1.2 and answers alike. */
    static EndpointImpl publish(Bus bus, String name, SoapCallExecutor calls) {
        // the library itself sets no bound on elements and characters
        bus.setProperty("org.apache.cxf.stax.maxElementCount", 20_000L);
        bus.setProperty("org.apache.cxf.stax.maxChildElements", 5_000);
        bus.setProperty("org.apache.cxf.stax.maxElementDepth", 30);
        bus.setProperty("org.apache.cxf.stax.maxAttributeSize", 4_096);
        bus.setProperty("org.apache.cxf.stax.maxTextLength", 1_048_576L);
        bus.setProperty("org.apache.cxf.stax.maxXMLCharacters", 1_048_576L);
        EndpointImpl endpoint =
                new EndpointImpl(bus, new SoapServiceProvider(name, calls), SOAPBinding.SOAP12HTTP_BINDING);
        endpoint.setDataBinding(new SoapResponseBinding());
        endpoint.setProperties(Map.of(
                "exceptionMessageCauseEnabled",
                "false",
                "faultStackTraceEnabled",
                "false",
                // The payload of a call, as a tree.
                "source-preferred-format",
                "dom"));
        endpoint.getInInterceptors()
                .addAll(List.of(
                        new SoapVersionInterceptor(),
                        new BodyRejectionInterceptor(),
                        new DoctypeRejectionInterceptor(),
                        new AttributeLimitInterceptor(),
                        new CredentialHeaderInterceptor()));
        endpoint.getOutFaultInterceptors().add(new UndispatchedFaultInterceptor(calls));
        endpoint.publish("/" + name);
        return endpoint;
    }
}
