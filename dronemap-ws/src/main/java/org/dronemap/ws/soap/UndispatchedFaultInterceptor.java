package org.dronemap.ws.soap;

import java.util.regex.Pattern;
import javax.xml.stream.XMLStreamException;
import org.apache.cxf.binding.soap.SoapFault;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.apache.cxf.staxutils.DepthExceededStaxException;
import org.dronemap.core.time.FatalErrors;
import org.dronemap.ws.problem.OutageClassifier;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Gives faults of SOAP messages that reached no operation the same problem code and sentence as REST has for them. */
final class UndispatchedFaultInterceptor extends AbstractPhaseInterceptor<Message> {
    private static final Logger LOG = LoggerFactory.getLogger(UndispatchedFaultInterceptor.class);

    /** How the parser tells of its own bounds. */
    private static final Pattern BOUND = Pattern.compile("limit \\(\\d+\\)");

    private static final String BEYOND = "This XML has more elements, or deeper ones, than are allowed here.";

    private final SoapCallExecutor calls;

    UndispatchedFaultInterceptor(SoapCallExecutor calls) {
        super(Phase.PRE_LOGICAL);
        this.calls = calls;
    }

    /** For what is no call at all. */
    static SoapFault unreadable(String sentence) {
        return new SoapFault(sentence, Fault.FAULT_CODE_CLIENT);
    }

    @Override
    public void handleMessage(Message message) {
        Exception thrown = message.getContent(Exception.class);
        if (thrown instanceof SoapFault told && told.hasDetails()) {
            return;
        }
        Rejection ofBody = message.getExchange().get(Rejection.class);
        ProblemView problem = ofBody != null ? ProblemView.of(ofBody) : problem(thrown);
        message.setContent(Exception.class, calls.fault(problem));
    }

    private static ProblemView problem(Exception thrown) {
        FatalErrors.reportCause(thrown);
        for (Throwable cause = thrown; cause != null; cause = cause.getCause()) {
            if (cause instanceof Rejection rejection) {
                return ProblemView.of(rejection);
            }
            if (cause instanceof DepthExceededStaxException) {
                return unreadableXml(BEYOND);
            }
            if (cause instanceof XMLStreamException broken) {
                boolean bound =
                        BOUND.matcher(String.valueOf(broken.getMessage())).find();
                return unreadableXml(bound ? BEYOND : "This is not well-formed XML.");
            }
        }
        boolean ofTheCaller = thrown instanceof Fault fault && !Fault.FAULT_CODE_SERVER.equals(fault.getFaultCode());
        if (ofTheCaller && !(thrown.getCause() instanceof RuntimeException)) {
            return unreadableXml(ProblemView.shortened(String.valueOf(thrown.getMessage())));
        }
        Rejection outage = OutageClassifier.of(thrown).orElse(null);
        if (outage != null) {
            LOG.warn("A SOAP call came while the store was away: {}", String.valueOf(thrown.getMessage()));
            return ProblemView.of(outage);
        }
        LOG.error("A SOAP call failed", thrown);
        return ProblemView.internal();
    }

    private static ProblemView unreadableXml(String sentence) {
        return ProblemView.of(Rejection.of(RequestProblem.XML_UNREADABLE, sentence));
    }
}
