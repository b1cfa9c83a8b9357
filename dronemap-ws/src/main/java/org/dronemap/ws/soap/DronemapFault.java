package org.dronemap.ws.soap;

import jakarta.xml.ws.WebFault;
import org.dronemap.ws.service.Problem;

/** A request that was not carried out, as SOAP tells it. */
@WebFault(name = "DronemapFault", targetNamespace = Namespace.URI)
public class DronemapFault extends Exception {
    private static final long serialVersionUID = 1L;

    @SuppressWarnings("serial") // faults cross the wire as XML only
    private final SoapFaultDetail detail;

    public DronemapFault(String message, SoapFaultDetail detail) {
        super(message);
        this.detail = detail;
    }

    static DronemapFault of(Problem problem) {
        return new DronemapFault(problem.detail(), SoapFaultDetail.of(problem));
    }

    public SoapFaultDetail getFaultInfo() {
        return detail;
    }
}
