package org.dronemap.ws.soap;

import java.util.List;
import java.util.stream.Collectors;
import javax.xml.namespace.QName;
import org.apache.cxf.message.Exchange;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.apache.cxf.service.model.BindingOperationInfo;
import org.apache.cxf.service.model.MessagePartInfo;
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
        Exchange exchange = message.getExchange();
        note(exchange);
        List<?> arguments = message.getContent(List.class);
        BindingOperationInfo operation = exchange.getBindingOperationInfo();
        if (arguments != null && operation != null) {
            Activity.current().ifPresent(call -> note(call, StrictElements.partsOf(operation), arguments));
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
                } else if (AuditRules.recordsElsewhere(name.getLocalPart())) {
                    call.leaveOutUnlessTurnedAway();
                }
            });
        }
    }

    /** Of what they are called as the operation declares it: the first as what it is of, of the rest only plain values. */
    private static void note(Activity call, List<MessagePartInfo> parts, List<?> arguments) {
        for (int i = 0; i < Math.min(parts.size(), arguments.size()); i++) {
            String name = parts.get(i).getConcreteName().getLocalPart();
            Object value = arguments.get(i);
            if (i == 0 && value instanceof String thing) {
                if (name.equals(MAVLinkController.DRONE)) {
                    call.drone(AuditNotes.told(thing));
                } else {
                    call.parameters(name + "=" + AuditNotes.told(thing));
                }
            } else if (value instanceof List<?> many && many.stream().allMatch(String.class::isInstance)) {
                String told = many.stream().map(String::valueOf).collect(Collectors.joining(" "));
                String what = name.equals(MAVLinkController.DRONE) ? "drones" : name;
                call.parameters(what + "=" + AuditNotes.told(told));
            } else if (value instanceof String text) {
                call.parameters(AuditNotes.told(text), "");
            } else if (value instanceof Number || value instanceof Boolean) {
                call.parameters(value.toString());
            }
        }
    }
}
