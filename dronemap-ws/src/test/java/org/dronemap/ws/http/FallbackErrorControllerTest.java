package org.dronemap.ws.http;

import static org.assertj.core.api.Assertions.assertThat;

import jakarta.servlet.RequestDispatcher;
import org.dronemap.ws.problem.ProblemView;
import org.junit.jupiter.api.Test;
import org.springframework.http.ResponseEntity;
import org.springframework.mock.web.MockHttpServletRequest;
import org.springframework.mock.web.MockHttpServletResponse;

class FallbackErrorControllerTest {
    private final FallbackErrorController answers = new FallbackErrorController();
    private final MockHttpServletRequest request = new MockHttpServletRequest();
    private final MockHttpServletResponse response = new MockHttpServletResponse();

    @Test
    void tellsWhatWentWrongAsAProblem() {
        request.setAttribute(RequestDispatcher.ERROR_STATUS_CODE, 413);

        ResponseEntity<ProblemView> answer = answers.error(request, response);

        assertThat(answer).isNotNull();
        assertThat(answer.getStatusCode().value()).isEqualTo(413);
    }

    @Test
    void addsNothingToAnAnswerThatIsOnItsWay() {
        request.setAttribute(RequestDispatcher.ERROR_STATUS_CODE, 500);
        response.setContentType("text/xml");
        response.setCommitted(true);

        assertThat(answers.error(request, response)).isNull();
    }
}
