package org.dronemap.ws.soap;

import javax.xml.stream.XMLStreamException;
import org.apache.cxf.binding.soap.Soap11;
import org.apache.cxf.binding.soap.SoapFault;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.apache.cxf.staxutils.DepthExceededStaxException;
import org.dronemap.core.time.FatalErrors;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RequestProblem;

/** Says in each fault whose mistake it was, and what is wrong with XML that cannot be read, as the other faces say it. */
final class FaultWords extends AbstractPhaseInterceptor<Message> {

    FaultWords() {
        super(Phase.PRE_LOGICAL);
    }

    /** What a client sees of a problem; its own mistakes carry the code for that. */
    static Fault fault(Problem problem) {
        DronemapFault ours = DronemapFault.of(problem);
        return coded(new Fault(ours), ours);
    }

    private static Fault coded(Fault fault, DronemapFault ours) {
        fault.setFaultCode(ours.isOfTheCaller() ? Fault.FAULT_CODE_CLIENT : Fault.FAULT_CODE_SERVER);
        return fault;
    }

    /** For what is no call at all: no operation, and so no detail. */
    static SoapFault unreadable(String sentence) {
        return new SoapFault(sentence, Soap11.getInstance().getSender());
    }

    @Override
    public void handleMessage(Message message) {
        NamedCalls.note(message.getExchange());
        Exception thrown = message.getContent(Exception.class);
        Fault told = thrown instanceof Fault fault ? inOurWords(message, fault) : null;
        if (told != null) {
            if (Fault.FAULT_CODE_SERVER.equals(told.getFaultCode())) {
                AuditNotes.turnedAway(Problem.internal());
            } else {
                AuditNotes.turnedAway(
                        Problem.of(Rejection.of(RequestProblem.XML_UNREADABLE, "The XML cannot be read.")));
            }
            message.setContent(Exception.class, told);
        }
    }

    private static Fault inOurWords(Message message, Fault fault) {
        if (fault.getCause() instanceof DronemapFault ours) {
            return coded(fault, ours);
        }
        Rejection ofBody = message.getExchange().get(Rejection.class);
        if (ofBody != null) {
            return unreadable(Problem.of(ofBody).detail());
        }
        InvalidInput unreadable = message.getExchange().get(InvalidInput.class);
        if (unreadable != null) {
            return fault(Problem.of(unreadable));
        }
        FatalErrors.tellOf(fault);
        for (Throwable cause = fault; cause != null; cause = cause.getCause()) {
            if (cause instanceof DepthExceededStaxException) {
                return unreadable("This XML has more elements, or deeper ones, than are allowed here.");
            }
            if (cause instanceof XMLStreamException) {
                return unreadable("This is not well-formed XML.");
            }
            if (cause instanceof Rejection rejection) {
                return fault(Problem.of(rejection));
            }
        }
        if (fault.getCause() instanceof RuntimeException && Fault.FAULT_CODE_SERVER.equals(fault.getFaultCode())) {
            return fault(Answering.problem(fault));
        }
        fault.setMessage(Problem.shortened(String.valueOf(fault.getMessage())));
        return fault;
    }
}
