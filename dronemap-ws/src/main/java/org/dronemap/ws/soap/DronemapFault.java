package org.dronemap.ws.soap;

import jakarta.xml.ws.WebFault;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.Problem;

/** A request that was not carried out, as SOAP tells it. */
@WebFault(name = "DronemapFault", targetNamespace = Namespace.URI)
public class DronemapFault extends Exception {
    private static final long serialVersionUID = 1L;

    @SuppressWarnings("serial") // faults cross the wire as XML only
    private final SoapFaultDetail detail;

    private final boolean ofTheCaller;

    /** For clients, which learn whose mistake it was from the fault code. */
    public DronemapFault(String message, SoapFaultDetail detail) {
        this(message, detail, true);
    }

    private DronemapFault(String message, SoapFaultDetail detail, boolean ofTheCaller) {
        super(message);
        this.detail = detail;
        this.ofTheCaller = ofTheCaller;
    }

    static DronemapFault of(Problem problem) {
        AuditNotes.turnedAway(problem);
        return new DronemapFault(problem.detail(), SoapFaultDetail.of(problem), problem.status() < 500);
    }

    boolean isOfTheCaller() {
        return ofTheCaller;
    }

    public SoapFaultDetail getFaultInfo() {
        return detail;
    }
}
