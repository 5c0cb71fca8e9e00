# The texts of the reports of pairs and blocks in Arabic, by name: figures are written before they come here.

report-language = ar
    .direction = rtl

## Both reports

report-settings = الإعدادات
report-default = الافتراضي
report-default-is = الافتراضي: { $value }
report-footer = ‏Tiepoint { $version }. الصور والإعدادات نفسها تعطي التقرير نفسه.
report-separator = {"،\u200F "}
report-quantity = {"\u2067"}{ $value } { $unit }{"\u2069"}
report-head = {"\u2067"}{ $name } ({ $unit }){"\u2069"}
report-in-unit = {"\u2067"}{ $name }، { $unit }{"\u2069"}
report-of = { $part } من { $all }
report-residuals = المتبقيات
report-reliability = الموثوقية
report-cameras = الكاميرات
report-truth = الحقيقة
report-state = الحالة
report-state-used = مستعملة
report-state-check = تحقق
report-state-doubtful = مشكوك فيها
report-state-rejected = مرفوضة
report-state-gross-error = خطأ جسيم
report-state-off = غير مستعملة
report-state-not-measured = غير مقيسة
report-state-untested = غير مختبَرة
report-state-not-determined = غير محدَّدة
report-state-not-placed = غير موضوعة
report-redundancy-number = عدد الفائض r
report-median = الوسيط
report-largest-w = أكبر المتبقيات المعيارية w
report-degrees-of-freedom = درجات الحرية

## Of a pair: its page

report-title = ‏تقرير Tiepoint: { $left }، { $right }
report-images-points-and-matches = الصور والنقاط والمطابقات
report-all-strategies = جميع الاستراتيجيات
report-compared-on = تُقارن الاستراتيجيات الأخرى على { $left_taken } من { $left } من النقاط اليسرى و{ $right_taken } من { $right } من النقاط اليمنى: نافذة كبت ضلعها { $window } بكسل تُبقي أبرزها. فالتدرجات تقارن كل نقطة يسرى بكل نقطة يمنى، ومقارنتها كلها تستغرق دقائق.
report-interior-orientation = التوجيه الداخلي
report-relative-orientation = التوجيه النسبي لهذا التشغيل
report-not-oriented = لم يُوجَّه: { $reason }.
report-size = { $name }، { $size } بكسل
report-sizes = اليسرى: { $left }؛ اليمنى: { $right }.
report-mask-of-left = يستبعد قناع { $share } من الصورة اليسرى.
report-mask-of-right = يستبعد قناع { $share } من الصورة اليمنى.
report-matches-of-points = طوبقت { $matches } من { $points } من النقاط اليسرى باستراتيجية هذا التشغيل.
report-edits-of-pair = التعديلات اليدوية: رُفضت { $rejected } من المطابقات، وقيست { $measured }. هذا التشغيل للمطابقات المعدَّلة؛ أما الاستراتيجيات الأخرى فتطابق بنفسها.
report-took-part = شاركت { $used } من المطابقات، σ₀ { $sigma0 } بكسل؛ ورُفض { $rejected } من الأخطاء الجسيمة.
report-right-by-truth = ‏{ $share } من المطابقات صحيحة، كما يبيّن الجواب المعروف للزوج المحاكى.
report-points-and-matches = { $name }: { $points } من النقاط، { $matches } من المطابقات
report-legend-matched = مطابَقة
report-legend-other = نقطة مميزة أخرى
report-legend-masked = مستبعَد بالقناع

## Of a pair: its cameras

report-origin = { $origin }: { $camera }
report-camera-given = معطاة
report-focal-by-geometry = غير معروفة: بعد بؤري من هندسة المشهدين
report-camera-assumed = غير معروفة: تُفترض كاميرا معظم الصور
report-focal-length = البعد البؤري
report-principal-point = النقطة الأساسية { $axis }
report-distortion = التشوه { $term }
report-left = اليسرى
report-right = اليمنى
report-as-known = كما كانت معروفة
report-estimated = مقدَّرة
report-from = المصدر
report-camera-errors = ‏±: الأخطاء المعيارية؛ ويُعد الثابت الذي لا خطأ له خاليًا من الأخطاء.
report-camera-estimated = مقدَّرة: مع التوجيه معًا، من المطابقات ومما كان معروفًا.
report-camera-axes = تُحسب النقطة الأساسية من وسط الصورة، أو في نظام العلامات الإطارية، وx إلى اليمين وy إلى أعلى. التشوه: حدود تصحيح براون بوحدات البعد البؤري، بحيث يكون k1 النسبة التي يزيح بها نقطة عند 45°.
report-pixel-unknown = حجم البكسل غير معروف: حيث تذكر جداول أخرى المليمتر يُعد البكسل 0.001 مم.

## Of a pair: the details of its run

report-photo-coordinates = لا علامات إطارية: تُحسب إحداثيات الصورة من حجم البكسل.
report-no-photo-coordinates = لا تُعرف علامات إطارية ولا كاميرا بحجم بكسلها: لا إحداثيات للصورة.
report-no-marks = لا علامات
report-affine = أفيني
report-similarity = تشابه
report-interior-by-marks = التوجيه الداخلي بالعلامات الإطارية
report-photo = الصورة
report-left-photo = اليسرى
report-right-photo = اليمنى
report-marks = العلامات
report-transformation = التحويل
report-largest-residual = أكبر متبقٍّ
report-y-parallaxes = متبقيات اختلاف المنظر الصادي فوق الصورة اليسرى
report-y-parallaxes-enlarged = متبقيات اختلاف المنظر الصادي مكبَّرة { $factor } مرة؛ والمرفوضة بالبرتقالي
report-y-parallaxes-of = اختلافات المنظر الصادية للمطابقات المستعملة، وعددها { $matches }؛ خطؤها المعياري { $sigma } بكسل
report-detectable-blunder = أصغر انحياز يمكن كشفه
report-external = الموثوقية الخارجية δ
report-weight = الوزن
report-reliability-of = موثوقية المطابقات المستعملة (α₀ { $alpha0 }، β₀ { $beta0 })
report-least = الأصغر
report-largest = الأكبر
report-reliability-of-pair = ‏r نصيب الخطأ الذي يظهر في المتبقي. يُكشف خطأ بقدر أصغر انحياز يمكن كشفه باحتمال β₀؛ وما لا يُكشف منه لا يغيّر أي مجهول بأكثر من δ من أخطائه المعيارية.
report-most-unfound = المطابقات ذوات أكبر موثوقية خارجية
report-match = المطابقة
report-y-parallax = اختلاف المنظر الصادي
report-sigma-of-coordinate = ‏σ₀ لإحداثي الصورة
report-sigma-value = { $um } ميكرومتر = { $px } بكسل
report-matches-used = المطابقات المستعملة
report-base-together = ‏by وbz معًا، 95 %
report-ellipse-of = قطع ناقص نصفا محوريه { $axes } مم
report-condition = العدد الشرطي
report-plane-misfit = عدم المواءمة لمستوى
report-parallax-beside = اختلاف المنظر بعد الدوران
report-global-test = الاختبار الكلي
report-global-passed = { $statistic }، والمتوقع بين { $lower } و{ $upper }: ناجح
report-global-failed = { $statistic }، والمتوقع بين { $lower } و{ $upper }: مخفق
report-axes = المحاور
report-axes-turned = مدارة 90°: يتجه x إلى أعلى في الصورة اليسرى
report-warning = تحذير
report-sigma-from-parallaxes = تُحسب σ₀ من اختلافات المنظر الصادية: مطابقة خاطئة على امتداد خطها القطبي لا تغيّرها.
report-correlations = ارتباطات المجاهيل
report-error-ellipse = ‏by وbz: قطع الخطأ المعياري، نصفا محوريه { $axes } ميكرومتر
report-ellipse-dashed = ؛ المتقطع: 95 %
report-ellipse-cross = ؛ علامة التقاطع: الحقيقة

## Of a pair: the tables of the paper

report-table-1 = الجدول 1. النقاط بعد كل مرحلة
report-phase = المرحلة
report-operator = المؤثر
report-roundness = عتبة الاستدارة
report-suppression = كبت ما ليس أعظميًا
report-paper = البحث
report-paper-left = البحث، اليسرى
report-paper-right = البحث، اليمنى
report-matching-by = المطابقة: { $step }
report-became = ما آلت إليه النقاط اليسرى
report-rejected-by = مرفوضة: { $rule }
report-rejected-by-hand = من المطابَقة: مرفوضة يدويًا
report-measured-by-hand = مقيسة يدويًا، مكانها أو إلى جانبها
report-matched-gross-errors = من المطابَقة: أخطاء جسيمة
report-against-truth = المطابقات إزاء الحقيقة
report-right-at-edges = صحيحة، وعند الحواف أيضًا
report-strictly-right = صحيحة تمامًا
report-missed = تُرى في الصورتين ولم تطابَق مطابقة صحيحة
report-strictly-right-is = صحيحة تمامًا: تقع النقطة اليمنى ضمن 1.5 بكسل من المكان الذي يُرى فيه السطح عند البكسل الأيسر. عند الحواف أيضًا: أو عند أحد جيرانه الثمانية، لأن النقاط تقع على حواف قد يقفز عندها السطح بين بكسلين.
report-table-2 = الجدول 2. الأخطاء المعيارية
report-sigma-of-all = ‏σ₀ لجميع المطابقات
report-used = المطابقات المستعملة
report-in-total = الإجمالي: مع ما تشترك فيه المطابقات، وأخطاء الكاميرا والعلامات الإطارية المقيسة
report-half-widths = أنصاف عروض المجالات التي تحوي المجاهيل في 95 % من الحالات
report-sigma-of-all-is = ‏σ₀ لجميع المطابقات: مربعات صغرى من الزوج الشاقولي دون رفض الأخطاء الجسيمة ودون أوزان متينة. ولا تُذكر حيث لا يتقارب ذلك، ولا حيث قُدّرت الكاميرات.
report-table-3 = الجدول 3. التوجيه النسبي بكل استراتيجية
report-unknown = المجهول
report-paper-by = البحث: { $way }
report-paper-correlation = الارتباط
report-paper-least-squares = المربعات الصغرى
report-paper-moments = المقترحة (العزوم)
report-verdict = الحكم
report-fixed = { $unit }، ثابتة
report-true-errors = الأخطاء الحقيقية، وكم يبلغ كل منها من أخطائه المعيارية
report-other-base = ‏by وbz للحقيقة منسوبتان إلى قاعدتها البالغة { $base } مم. وحيث وُجّهت استراتيجية بقاعدة أخرى فأخطاؤها الحقيقية هي إزاء الحقيقة بمقياس تلك القاعدة.
report-paper-columns = عمودا البحث بالارتباط وبالمربعات الصغرى من 15 نقطة قاسها عمل سابق على مسح ضوئي بدقة 600 نقطة في البوصة: ولهما أخطاؤهما.

## Of a pair: what sets it apart from the paper

report-differs = أين يختلف هذا عن البحث، ولماذا
report-pair = الزوج. صور البحث غير منشورة.
report-pair-simulated = هذا الزوج محاكى: مشهد اصطناعي تراه كاميرا معروفة الموضع. نسيجه وتباينه ليسا كما في مشهد البحث، فتختلف معهما أعداد الجدول 1؛ ولا يذكر البحث قاعدته، فأُخذ لها تداخل 60 %.
report-pair-other = هذا زوج آخر: تتعلق كل قيمة بمشهده ومقياسه ومسحه الضوئي؛ فلا يُقارن إلا نوعها.
report-denominator-larger = المقدار الأكبر هو المقام
report-denominator-median = المقدار الأكبر هو المقام، أو المقدار الوسيط للعزم حيث يزيد عليه
report-ambiguous-many-parallax = ملتبسة، أو كثيرًا إلى واحد، أو حائدة عن اختلاف المنظر الصادي لجيرانها
report-ambiguous-many = ملتبسة أو كثيرًا إلى واحد
report-many-parallax = كثيرًا إلى واحد، أو حائدة عن اختلاف المنظر الصادي لجيرانها
report-many = كثيرًا إلى واحد
report-matches-differ = المطابقات. يقبل البحث أصغر مقياس دون 3 في نافذة البحث. ولمقياسه كما طُبع مقام قد ينعدم، وأفضل مرشح من كثير يكون دون 3 دائمًا تقريبًا. هنا { $denominator }، وتُرفض المطابقات حيث تكون { $inconsistent }: طوبقت { $matches } من { $points } من النقاط اليسرى ({ $share })؛ وفي البحث { $paper_matches } من { $paper_points } ({ $paper_share }).
report-sigma-of-paper = الجدول 2. ‏σ₀ في البحث 0.150 مم، أي 0.6 بكسل؛ وبالعزوم
report-sigma-here = تبلغ هنا { $sigma0 } بكسل، بعد التقدير المتين وتقصّي البيانات
report-pair-not-oriented = لم يُوجَّه هذا الزوج
report-sigma-of-all-here = ، وتبلغ { $sigma0 } بكسل لجميع المطابقات دون أي منهما
report-errors-grow = تكبر الأخطاء المعيارية مع σ₀ وتصغر مع جذر عدد المطابقات. وبقيمة σ₀ وعدد المطابقات في البحث تعطي هندسة هذا الزوج
report-beside-printed = { $value } (المطبوع { $printed })
report-printed-times = والمطبوعة من { $least } إلى { $most } أمثال هذه: لا تفسر ذلك σ₀ ولا العدد، ولا يذكر البحث قاعدته ولا مواضع نقاطه.
report-orientations-differ = الجدول 3. صُنعت أعمدة البحث الثلاثة من زوج واحد، وتختلف حتى 0.127° في κ و0.354 مم في by: أي 6.3 و2.6 من الأخطاء المعيارية التي يذكرها جدوله 2. والأخطاء المعيارية من المتبقيات على امتداد اختلافات المنظر الصادية لا تُظهر أخطاء جسيمة ضُبطت مع غيرها، ولا أخطاء التوجيه الداخلي التي تشترك فيها جميع نقاط الصورة.
report-largest-true-error = وهنا تقف الاستراتيجيات نفسها إلى جانب الحقيقة: أكبر خطأ حقيقي { $times } من أخطائه المعيارية ({ $unknown }، { $step }).

## Of a block: its head

report-block-title = ‏تقرير Tiepoint: كتلة من { $images } من الصور
report-plan = مراكز الإسقاط والاتصالات
report-images = الصور
report-oriented-of = { $oriented } موجَّهة من { $read } مقروءة
report-not-read = ؛ تعذّرت قراءة { $images }
report-with-masks = ؛ { $images } لها أقنعة
report-pairs = الأزواج
report-connected-of = { $connected } متصلة من { $tried } مجرَّبة
report-points-found = نقاط الربط الموجودة
report-points-written = نقاط الربط المكتوبة
report-with-observations = { $points }، الأرصاد: { $observations }
report-coordinate-system = نظام إحداثيات الجداول
report-axes-of-report = محاور هذا التقرير
report-axes-local = ‏X شرقًا وY شمالًا وZ إلى أعلى في وسط الكتلة، بالمتر
report-edits-of-block = التعديلات اليدوية
report-models = انقسمت الكتلة إلى { $models } من النماذج، صورها { $images }. هذا التقرير عن أولها.
report-georeferenced-by = الإسناد الجغرافي
report-datum-none = بلا شيء: لا معنى للموضع والدوران والمقياس
report-datum-control = بنقاط الضبط الأرضي
report-datum-gnss-and-control = بمواضع GNSS ونقاط الضبط الأرضي
report-datum-gnss = بمواضع GNSS
report-rmse-of-observations = ‏RMSE الأرصاد
report-observations-rejected = الأرصاد المرفوضة
report-rmse-of-gnss = ‏RMSE مواضع GNSS
report-in-xyz = { $x }، { $y }، { $z } م في X وY وZ
report-rmse-of-checks = ‏RMSE نقاط التحقق، وعددها { $points }
report-checks = { $x }، { $y }، { $z } م في X وY وZ (الأفقي { $plan } م)، المتوسط { $mean_x }، { $mean_y }، { $mean_z } م
report-along-axes = ، على محاور { $crs }
report-ratio-of-checks = ؛ { $ratio } من أخطائها المعيارية
report-block-against-truth = إزاء الحقيقة
report-right-points = { $right } من { $points } من النقاط صحيحة
report-truth-positions = ؛ بعد تحويل تشابه ينقلها إلى الحقيقة RMSE المواضع { $x }، { $y }، { $z } م
report-truth-angles = ، والزوايا { $angle }°
report-warnings = التحذيرات
report-remarks = ملاحظات على ما أُعطي
report-more-in-summary = في الملف summary.json ‏{ $number } أخرى.

## Of a block: its plan

report-plan-of = مسقط { $centres } من مراكز الإسقاط
report-ellipses-95 = قطوع ناقصة تحوي مراكز الإسقاط في 95 % من الحالات، { $grown } أمثال قطوع الخطأ المعياري، وبمقياس يبلغ { $factor } أمثال مقياس المسقط
report-ellipses-standard = قطوع الخطأ المعياري، بمقياس يبلغ { $factor } أمثال مقياس المسقط
report-one-of = ؛ رُسم واحد من كل { $step }
report-no-standard-errors = لا توجد أخطاء معيارية.
report-triangles = المثلثات: نقاط الضبط الأرضي (بالأخضر) ونقاط التحقق (بالأزرق).
report-plane-of-images = ليس للكتلة نظام: المستوى هو ما تنظر إليه صورها.
report-no-links = لا نقاط مشتركة بين أي صورتين.
report-links = تصل الخطوط صورًا لها نقاط مشتركة: حتى { $bounds } منها، والأعرض للأكثر.
report-strongest-links = من { $links } من الخطوط رُسم أقواها وعددها { $drawn }.
report-scale-of-plan = {"\u2067"}المسقط: { $length } { $unit }{"\u2069"}
report-scale-of-ellipses = {"\u2067"}القطوع: { $length } { $unit }{"\u2069"}
report-model-units = وحدات النموذج

## Of a block: its precision

report-precision = الدقة
report-minimum = الأصغر
report-maximum = الأكبر
report-point-coordinate = النقاط، { $axis }
report-projection-centres = مراكز الإسقاط
report-points = النقاط
report-longest-semi-axes = أطول أنصاف محاور مجسمات 95 % الإهليلجية
report-inner-constraints = بالنسبة إلى القيود الداخلية لشبكة حرة.
report-standard-errors = الأخطاء المعيارية لمراكز الإسقاط والزوايا والنقاط
report-and-95 = ، ± 95 %
report-fewest-observations = الصور ذات أقل الأرصاد
report-and-errors-95 = ؛ الأخطاء المعيارية ± 95 %
report-image = الصورة
report-observations = الأرصاد
report-von-gruber = مواضع فون غروبر
report-of-nine = { $positions } من 9
report-ellipsoid-95 = مجسم 95 % الإهليلجي
report-longest-ellipsoids = النقاط ذات أطول مجسمات 95 % الإهليلجية؛ الأخطاء المعيارية ± 95 %
report-point = النقطة
report-points-numbered = النقاط مرقمة كما في points.csv، ولنقاط الضبط الأرضي ونقاط التحقق أسماؤها.
report-semi-axes = المجسم الإهليلجي: أنصاف محاوره، وأطولها أولًا.
report-images-not-oriented = الصور غير الموجَّهة
report-images-not-read = الصور التي تعذّرت قراءتها
report-reason = السبب
report-interval-95 = ‏±: نصف عرض المجال الذي يحوي الحقيقة في 95 % من الحالات، وهو { $interval } من الأخطاء المعيارية (بتوزيع ستودنت لدرجات الحرية؛ وبالتوزيع الطبيعي حيث أُعطيت σ₀).
report-ellipses-and-ellipsoids = تحوي القطوع الناقصة والمجسمات الإهليلجية إحداثيين أو ثلاثة معًا في 95 % من الحالات: هي { $ellipse } و{ $ellipsoid } أمثال المعيارية منها (توزيع F).

## Of a block: its cameras

report-more-cameras = في الملف summary.json ‏{ $number } من الكاميرات الأخرى.
report-camera = الكاميرا { $number }: { $label }، { $images } من الصور ذات { $size } بكسل
report-given = المعطى
report-calibrated = المعايَر
report-standard-error = الخطأ المعياري
report-parameter-correlations = ارتباطات المعاملات المقدَّرة
report-not-determined-by = غير محدَّد: خطأ معياري واحد يزيح رصدة بمقدار { $effect } بكسل
report-not-determined = غير محدَّد
report-not-estimated = غير مقدَّر
report-few-residuals = المتبقيات أقل مما يلزم لحقل متبقيات.
report-mean-residuals = متوسطات المتبقيات عبر الصورة، { $observations } من الأرصاد: الجذر التربيعي لمتوسط مربعاتها { $rms } بكسل، وبالصدفة وحدها { $chance } بكسل
report-enlarged = ؛ مكبَّرة { $factor } مرة

## Of a block: its observations

report-residuals-of = متبقيات { $observations } من الأرصاد المقبولة، الأعمدة والصفوف؛ σ₀ تبلغ { $sigma0 } بكسل
report-by-rays = بحسب عدد أشعة نقاطها
report-rays = الأشعة
report-detectable-error = أصغر خطأ يمكن كشفه
report-influence = الأثر
report-moves-its-point = غير مكشوف، يزيح نقطته بمقدار
report-no-statistics = لا توجد إحصاءات.
report-accepted-observations = أعمدة جميع الأرصاد المقبولة وصفوفها
report-reliability-of-block = ‏r نصيب الخطأ الذي يظهر في المتبقي. يُكشف خطأ بقدر أصغر ما يمكن كشفه باحتمال 0.80. وإن لم يُكشف لم يُزح أي مجهول بأكثر من الأثر، بالأخطاء المعيارية.
report-unchecked = لعدد { $observations } من الأرصاد إحداثي لا يراقبه شيء.
report-largest-detectable = أكبر الأخطاء التي يمكن كشفها
report-largest-influences = أكبر الآثار
report-did-not-fit = لم توافق نقطتها أثناء نمو الكتلة
report-lay-behind = وقعت نقطتها خلف الصورة أثناء نمو الكتلة
report-by-hand = رُفضت يدويًا
report-snooped = وجد تقصّي البيانات خطأً جسيمًا
report-lies-behind = تقع نقطتها خلف الصورة
report-lost-point = لم يبق لنقطتها شعاعان، أو لا تلتقي أشعتها
report-rejected-observations = الأرصاد المرفوضة
report-rejected-of = رُفضت { $rejected } من { $observations } من الأرصاد ({ $share }).
report-gross-errors = الأخطاء الجسيمة ذات أكبر المتبقيات المعيارية w
report-observed-point = النقطة
report-moves-by = يزيح نقطته

## Of a block: positions of images, control points and check points

report-gnss = مواضع GNSS
report-all-took-part = شاركت { $part } من { $all }.
report-part-took-part = شاركت { $part } من { $all }؛ وتبعد الأخرى كثيرًا عما تضعها فيه الصور.
report-part-took-part-in-strips = شاركت { $part } من { $all }؛ وتبعد الأخرى كثيرًا عما تضعها فيه الصور، أو ليست في أي خط طيران.
report-gnss-that-took-part = مواضع GNSS المشاركة
report-absolute-residual = |المتبقي| { $axis }
report-redundancy-of = عدد الفائض r { $axis }
report-detectable-error-of = أصغر خطأ يمكن كشفه { $axis }
report-moves-of = غير مكشوف، يزيح { $axis } بمقدار
report-influence-of = الأثر { $axis }
report-all-gnss = جميع مواضع GNSS، وأكبر المتبقيات المعيارية w أولًا
report-gnss-residuals = المتبقي: المرصود ناقص المضبوط. r نصيب الخطأ الذي يظهر في المتبقي؛ ويُكشف أصغر خطأ يمكن كشفه باحتمال 0.80. وإن لم يُكشف أزاح الإحداثي المضبوط بمقدار «الإزاحة»، ولم يُزح أي مجهول بأكثر من «الأثر»، بالأخطاء المعيارية.
report-control = نقاط الضبط الأرضي
report-image-measurements = القياسات الصورية
report-residual-of = المتبقي { $axis }
report-moves = الإزاحة { $axis }
report-control-residuals = المتبقي: الممسوح ناقص المضبوط؛ وw هي لرصدة جديدة حيث رُفضت النقطة لأن الأرصاد الأخرى تناقضها. والنقطة المشكوك فيها تناقضها أيضًا، وتبقى مستعملة لأن ما يبقى دونها أقل من أن يبيّن أيها خاطئ.
report-control-as-gnss = ‏r و∇ والإزاحة والأثر كما لمواضع GNSS: ما يزيح به النقطةَ خطأ غير مكشوف قدره ∇، وأكثر ما يزيح به أي مجهول، بالأخطاء المعيارية. ما زاد على { $most } من النقاط في surveyed.csv.
report-control-axes = متبقيات النقاط المستعملة على محاور الضبط، ومتبقيات النقاط المرفوضة والفروق كلها على محاور { $crs }.
report-left-out = النقاط نفسها دون مشاركتها
report-left-out-is = حيث تضع سائر الأرصاد كل نقطة من هذه، ناقص الممسوح: قيمتها لو كانت نقطة تحقق.
report-check-points = نقاط التحقق
report-check-differences = الفروق: المضبوط ناقص الممسوح. لم تشارك في الضبط.
report-check-differences-along = الفروق: المضبوط ناقص الممسوح، على محاور { $crs }. لم تشارك في الضبط.
report-without-figures = نقاط ضبط وتحقق بلا قيم
report-use = الاستعمال
report-use-control = ضبط
report-use-check = تحقق
report-use-off = غير مستعملة
report-states-explained = غير مقيسة: لا يسمي النقطةَ أي قياس صوري. غير مختبَرة وغير محدَّدة: لا يوافق الكتلةَ من قياسات النقطة الصورية اثنان؛ ولا تشارك نقطة الضبط حينئذ. غير موضوعة: لا نقاط ضبط تضع الكتلة. مرفوضة: موضع في الصورة المصححة يناقض غيره.
report-points-beyond = ما زاد على { $most } من النقاط في surveyed.csv.
report-stated-errors = الأخطاء المعيارية المعطاة
report-group = الأرصاد
report-coordinates = الإحداثيات
report-redundancy = الفائض
report-by-residuals = بالمتبقيات / المعطى
report-interval = مجال 95 %
report-weights-by = الأوزان بحسب
report-by-their-residuals = المتبقيات
report-by-stated-held = الأخطاء المعيارية المعطاة (مثبَّتة)
report-by-stated = الأخطاء المعيارية المعطاة
report-components-explained = مركبات التباين: الأخطاء المعيارية بحسب المتبقيات إلى جانب المعطاة. والعامل الذي لا يحدده الفائض يُثبَّت عند 1.
report-weights-follow = تتبع الأوزان المتبقيات حيث يقع 1 خارج المجال، وتبقى كذلك متى تبعتها.
report-weights-stated = الأوزان أوزان الأخطاء المعيارية المعطاة.
report-rounds = جولات الوزن: { $rounds }.
report-weights-did-not-converge = لم تتقارب الأوزان.
report-systematic = الأخطاء المنتظمة لمواضع GNSS
report-error = الخطأ
report-test = الاختبار
report-limit = الحد
report-strip = خط الطيران { $number }: { $images } من الصور من { $first } إلى { $last }.
report-systematic-explained = الموضع المرصود = مركز الإسقاط + الخطأ. ذراع الهوائي على محاور الكاميرا (x إلى اليمين، y إلى أعلى، z عكس اتجاه النظر)؛ والانجراف ما يكبر به الخطأ من أول صورة في خط الطيران إلى آخرها. الاختبار: متوسط المربعات بالأخطاء المعيارية، وما فوق الحد ليس من الصدفة.
report-few-control = نقاط الضبط الأرضي قليلة: ما تزيح به الأخطاءُ الكتلةَ كلها أو تدورها أو تقيسها به ليس محسوبًا فيها.
report-measurements = القياسات الصورية لهذه النقاط
report-measurements-took-part = شارك { $part } من { $all }؛ RMSE ‏{ $rmse } بكسل.
report-largest-residuals = أكبر المتبقيات
report-moves-point-by = يزيح النقطة
