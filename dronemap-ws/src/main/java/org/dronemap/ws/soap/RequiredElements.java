package org.dronemap.ws.soap;

import java.lang.reflect.AnnotatedType;
import java.lang.reflect.Method;
import java.util.List;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.apache.cxf.service.invoker.MethodDispatcher;
import org.apache.cxf.service.model.BindingOperationInfo;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.Problem;
import org.jspecify.annotations.Nullable;

/** Turns away calls without an element that their operation cannot do without. */
final class RequiredElements extends AbstractPhaseInterceptor<Message> {
    RequiredElements() {
        super(Phase.PRE_INVOKE);
        addAfter(NamedCalls.class.getName());
    }

    @Override
    public void handleMessage(Message message) {
        BindingOperationInfo operation = message.getExchange().getBindingOperationInfo();
        List<?> arguments = message.getContent(List.class);
        Object methods = message.getExchange().getService().get(MethodDispatcher.class.getName());
        if (operation == null || arguments == null || !(methods instanceof MethodDispatcher dispatcher)) {
            return;
        }
        Method method = dispatcher.getMethod(operation);
        AnnotatedType[] wanted = method.getAnnotatedParameterTypes();
        for (int i = 0; i < wanted.length; i++) {
            boolean there = i < arguments.size() && arguments.get(i) != null;
            // A list without elements is not there either; the operations say what they want of one.
            boolean list = List.class.isAssignableFrom(method.getParameterTypes()[i]);
            if (!there && !list && !wanted[i].isAnnotationPresent(Nullable.class)) {
                throw missing(operation, i);
            }
        }
    }

    private static RuntimeException missing(BindingOperationInfo operation, int index) {
        String name =
                StrictElements.partsOf(operation).get(index).getConcreteName().getLocalPart();
        return FaultWords.fault(Problem.of(InvalidInput.missing(name, "a text")));
    }
}
