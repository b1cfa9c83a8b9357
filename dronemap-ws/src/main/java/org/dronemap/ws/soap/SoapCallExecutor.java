package org.dronemap.ws.soap;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javax.xml.transform.Source;
import org.apache.cxf.binding.soap.SoapFault;
import org.apache.cxf.message.Message;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.security.ForwardedCaller;
import org.dronemap.ws.soap.description.SoapOperation;
import org.dronemap.ws.soap.description.SoapServices;
import org.dronemap.ws.soap.description.WsdlWriter;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.dronemap.ws.soap.xml.XmlGenerator;
import org.dronemap.ws.soap.xml.XmlType;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;

/**
 * Carries out SOAP calls: turns each into a REST request within the server, and its answer into a SOAP message. Any
 * thread.
 */
public final class SoapCallExecutor {
    private static final String COMMAND_ID = "commandId";
    private static final XmlType COMMAND = new XmlType.Named("CommandView");

    private final SoapContract contract;
    private final SoapAuthentication caller;
    private final InProcessRestClient rest;
    private final JsonCodec json;

    public SoapCallExecutor(
            SoapContract contract, SoapAuthentication caller, InProcessRestClient rest, JsonCodec json) {
        this.contract = contract;
        this.caller = caller;
        this.rest = rest;
        this.json = json;
    }

    /** A call under way. */
    record Called(
            SoapOperation operation,
            HttpServletRequest from,
            ForwardedCaller by,
            CompletableFuture<RestResponse> answer) {}

    /** {@code payload}: what stands in the body of the message; null: nothing. */
    Called begin(String service, @Nullable Element payload, Message message, HttpServletRequest from) {
        SoapServices services = contract.services();
        try {
            if (payload == null) {
                throw Rejection.of(
                        RequestProblem.REQUEST_UNREADABLE,
                        "The body of a SOAP message must have the element of an operation.");
            }
            SoapOperation operation = operation(services, service, payload);
            // Until REST keeps the record.
            AuditedCall.current().ifPresent(call -> call.operation(operation.name()));
            var request = new SoapRequestReader(services.types(), json.mapper()).read(operation, payload);
            ForwardedCaller by = caller.of(message, from);
            return new Called(operation, from, by, rest.call(from, request, by, xmlWriter(services, operation)));
        } catch (Rejection rejection) {
            throw fault(ProblemView.of(rejection));
        }
    }

    private static SoapOperation operation(SoapServices services, String service, Element payload) {
        if (!SoapNamespaces.URI.equals(payload.getNamespaceURI())) {
            throw Rejection.of(
                    RequestProblem.REQUEST_UNREADABLE,
                    "The element " + payload.getLocalName() + " must be in the namespace " + SoapNamespaces.URI
                            + "; it is in " + payload.getNamespaceURI() + ".");
        }
        return services.service(service)
                .flatMap(one -> one.operation(payload.getLocalName()))
                .orElseThrow(() -> Rejection.of(
                        RequestProblem.OPERATION_UNKNOWN,
                        service + " has no operation " + payload.getLocalName() + "; its description lists them."));
    }

    /** The message for the answer, which is there. */
    Source answer(Called called) {
        RestResponse answer = called.answer().getNow(null);
        if (answer == null) {
            throw fault(ProblemView.of(
                    Rejection.of(ServerProblem.OUTCOME_NOT_KNOWN, "The outcome is not known yet; ask for it later.")));
        }
        if (answer.tooLong()) {
            throw fault(ProblemView.of(tooLong(called)));
        }
        if (!answer.isRefusal()) {
            return message(called, answer);
        }
        JsonNode problem = problem(answer);
        if (problem.path(COMMAND_ID).isString() && isCommand(called.operation())) {
            return refused(called, problem);
        }
        throw SoapFaultFactory.of(problem, json.mapper(), contract.services().types());
    }

    private static boolean isCommand(SoapOperation operation) {
        return operation.answer() != null && operation.answer().type().equals(COMMAND);
    }

    /** A command that was refused has an outcome like any other. */
    private Source refused(Called called, JsonNode problem) {
        String uri = "/api/v1/commands/" + problem.path(COMMAND_ID).asString();
        var look = new RestRequest("GET", uri, Map.of());
        RestResponse command = rest.call(
                        called.from(), look, called.by(), xmlWriter(contract.services(), called.operation()))
                .getNow(null);
        if (command == null || command.isRefusal()) {
            throw SoapFaultFactory.of(
                    problem, json.mapper(), contract.services().types());
        }
        return message(called, command);
    }

    private Source message(Called called, RestResponse answer) {
        SoapOperation.Answer described = called.operation().answer();
        byte[] content = answer.getContentAsByteArray();
        if (described != null && described.json() && content.length > 0) {
            // Not every handler leaves the writing to Spring.
            answer.write(json.mapper().readTree(content));
        }
        if (answer.tooLong()) {
            throw fault(ProblemView.of(tooLong(called)));
        }
        return new SoapResponseSource(
                called.operation().name(), answer.xml(), described == null ? new byte[0] : content);
    }

    private RestResponse.@Nullable BodyWriter xmlWriter(SoapServices services, SoapOperation operation) {
        SoapOperation.Answer described = operation.answer();
        return described == null || !described.json()
                ? null
                : body -> XmlGenerator.write(
                        json.mapper(),
                        services.types(),
                        WsdlWriter.RETURN,
                        described.type(),
                        body,
                        RestResponse.LONGEST_BYTES);
    }

    private JsonNode problem(RestResponse answer) {
        try {
            JsonNode problem = json.mapper().readTree(answer.text());
            if (problem.isObject()) {
                return problem;
            }
        } catch (JacksonException notJson) {
            // Told below: there is no sentence of its own.
        }
        return json.mapper().valueToTree(ProblemView.ofStatus(answer.getStatus()));
    }

    private static Rejection tooLong(Called called) {
        return Rejection.of(
                RequestProblem.ANSWER_TOO_LARGE,
                "This answer is longer than a SOAP message may be, " + RestResponse.LONGEST_BYTES + " bytes; get it by "
                        + called.operation().of().method() + " "
                        + called.operation().of().path()
                        + " with the same key, or ask for less.");
    }

    SoapFault fault(ProblemView problem) {
        AuditNotes.turnedAway(problem);
        return SoapFaultFactory.of(
                json.mapper().valueToTree(problem),
                json.mapper(),
                contract.services().types());
    }
}
