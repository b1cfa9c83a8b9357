package org.dronemap.ws.soap;

import java.util.List;
import javax.xml.namespace.QName;
import org.apache.cxf.message.Exchange;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.dronemap.core.audit.Activity;
import org.dronemap.ws.service.AuditNotes;
import org.dronemap.ws.service.AuditRules;

/** Notes which operation a call is of, and of which drone, for the record that it leaves. */
final class NamedCalls extends AbstractPhaseInterceptor<Message> {
    NamedCalls() {
        super(Phase.PRE_INVOKE);
    }

    @Override
    public void handleMessage(Message message) {
        note(message.getExchange());
        List<?> arguments = message.getContent(List.class);
        if (arguments != null) {
            Activity.current().ifPresent(call -> note(call, arguments));
        }
    }

    /** What is known of it so far. */
    static void note(Exchange exchange) {
        if (exchange.getBindingOperationInfo() != null) {
            QName name = exchange.getBindingOperationInfo().getName();
            Activity.current().ifPresent(call -> {
                call.operation(name.getLocalPart());
                if (AuditRules.leavesOutSoap(name.getLocalPart())) {
                    call.leaveOut();
                }
            });
        }
    }

    /** Each operation that changes something is of a drone; of the rest only what are plain values. */
    private static void note(Activity call, List<?> arguments) {
        for (int i = 0; i < arguments.size(); i++) {
            Object value = arguments.get(i);
            if (i == 0 && value instanceof String drone) {
                call.drone(AuditNotes.told(drone));
            } else if (value instanceof String text) {
                call.parameters(AuditNotes.told(text), "");
            } else if (value instanceof Number || value instanceof Boolean) {
                call.parameters(value.toString());
            }
        }
    }
}
